#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/window/child_process.h"
#include "tests/window/display.h"

namespace throng::soak {

/// The real program in a window on a display of its own. What it does is read from the ui map
/// (app/window/panel/controls/ui_map.h) that it writes each frame.
class DrivenWindow {
 public:
  using Json = nlohmann::json;

  /// Starts display and program with these words. `folder` is where it works and keeps what a person keeps.
  DrivenWindow(const std::vector<std::string>& words, const std::filesystem::path& folder);

  /// Returns whether the program runs and has drawn a frame.
  bool is_there();
  pid_t process() const { return program_->process(); }
  /// Ends the program as a person does, and returns its exit status; nothing if it does not end.
  std::optional<int> end();

  /// Returns the newest ui map for which `holds` is true; nothing if there is none within a minute or so.
  std::optional<Json> wait_for(const std::function<bool(const Json&)>& holds);
  /// Returns the map of a frame that begins after now.
  std::optional<Json> next_map(int frames = 2);

  /// Gives words to xdotool; several commands may follow each other.
  bool xdotool(const std::vector<std::string>& words);
  /// Moves the pointer to a widget, presses, goes to a share of its width, and lets go.
  bool drag(const Json& widget, double share);
  bool drop(const std::string& file);

 private:
  std::filesystem::path folder_;
  app::Display display_;
  std::unique_ptr<app::ChildProcess> program_;
};

}  // namespace throng::soak
