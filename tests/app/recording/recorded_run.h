#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "app/show/replay.h"
#include "tests/app/temporary_folder.h"

namespace throng::app::test {

inline constexpr anim::Ticks sixtieth = anim::ticks_per_second / 60;

/// Options of a headless run without pictures, as the command line gives them.
DemoOptions demo(const std::string& line);
std::unique_ptr<Show> show_of(const DemoOptions& options);
void change(Show& show, const std::function<void(Tuning&)>& values);

/// The same bytes of a recording that was ended, with the checksum that they should have: what a careful liar writes.
std::string with_true_checksum(std::string recording);

/// A show recorded into a file, and that repeated.
class RecordedRun : public TemporaryFolder {
 protected:
  /// What somebody does at the window before a frame, from 1.
  using Act = std::function<void(Show&, int frame)>;
  void record(Show& show, int frames, const Act& act) const;

  /// The first difference, or the summary.
  std::string repeated(const std::string& line) const;
  /// "(as recorded)" if that is so with the PUs and schedule of the recording and with others; else the first
  /// difference.
  std::string repeated_in_any_schedule() const;

  std::string bytes() const;
  void put(const std::string& bytes) const;

  const std::filesystem::path file_ = folder_ / "run.rec";
};

}  // namespace throng::app::test
