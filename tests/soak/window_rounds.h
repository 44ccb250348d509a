#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "tests/soak/command_lines.h"
#include "tests/soak/driven_window.h"
#include "tests/soak/growth.h"
#include "tests/soak/round.h"

namespace throng::soak {

/// Rounds with one window that stays open: keys, clicks, drags, typed values, sizes and dropped models at random, while
/// it records. The recording is repeated without a window. After each round the window rests with the crowd that it
/// began with, and its process takes as much as before.
class WindowRounds {
 public:
  /// `folder` is the window's own, where models are copied to: a person may keep choices beside them.
  WindowRounds(const Models& models, const std::filesystem::path& folder);

  Fault run(const RoundPlace& place);
  void measure(Growth& growth) const;
  /// Returns how many files this process has open to read what display and program say.
  int open_files() const { return window_ == nullptr ? 0 : 2; }
  /// Closes the window. A fault is that it does not end well.
  Fault close();
  std::string table() const { return table_of("window", counts_); }

 private:
  using Json = DrivenWindow::Json;

  Fault open();
  Fault act(Random& random);
  bool use_a_widget(Random& random, const Json& map);
  bool press_a_key(Random& random);
  bool resize(Random& random);
  bool look_around(Random& random);
  bool drop(Random& random);
  bool press_when_not_typing(const std::string& key);
  Fault begin_recording();
  Fault end_recording(const RoundPlace& place);
  Fault rest();
  Fault gone(const std::string& when);

  std::filesystem::path folder_;
  Models models_;  // the copies
  std::unique_ptr<DrivenWindow> window_;
  Counts counts_;
};

}  // namespace throng::soak
