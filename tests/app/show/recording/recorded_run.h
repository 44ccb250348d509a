#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "app/show/replay.h"
#include "tests/app/temporary_folder.h"

namespace throng::app::test {

inline constexpr Ticks sixtieth = ticks_per_second / 60;

/// Returns the options of a headless run without pictures, as the command line gives them.
DemoOptions demo(const std::string& line);
std::unique_ptr<Show> show_of(const DemoOptions& options);
void change(Show& show, const std::function<void(Tuning&)>& values);
/// Makes a request, which the show must take.
void ask(Show& show, const CrowdRequest& request);
/// Returns the request to push the selected agent away from the camera.
Push push_of_selected(const Show& show);

/// Returns the same bytes of a recording that was ended, with the checksum that they should have. A careful liar would
/// write this.
std::string with_true_checksum(std::string recording);

/// A test that records a show into a file, and repeats it.
class RecordedRun : public TemporaryFolder {
 protected:
  /// The acts of somebody at the window before a frame, which counts from 1.
  using Act = std::function<void(Show&, int frame)>;
  void record(Show& show, int frames, const Act& act) const;

  /// Repeats the recording. Returns the first difference, or the summary.
  std::string repeated(const std::string& line) const;
  /// Repeats the recording with several numbers of PUs and schedules. Returns "(as recorded)" if none differs, else the
  /// first difference.
  std::string repeated_in_any_schedule() const;

  std::string bytes() const;
  void put(const std::string& bytes) const;

  const std::filesystem::path file_ = folder_ / "run.rec";
};

}  // namespace throng::app::test
