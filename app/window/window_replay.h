#pragma once

#include <cstdint>

#include "app/show/report/replay_report.h"
#include "app/show/request/request.h"
#include "engine/base/result.h"

namespace throng::app {

class Replay;
class Show;

/// A replay in a window: it plays at the speed of the recording, pauses, steps, and goes to any frame. At its end, and
/// where a frame differs, it stays and says so.
class WindowReplay {
 public:
  /// Counts the frames of the recording. `replay`, which outlives this, has begun and repeated nothing yet.
  explicit WindowReplay(Replay& replay);

  /// Carries out the person's requests.
  void take(const ReplayRequest& request);
  /// Repeats the frames of the next `seconds`, or some frames on the way to the requested one. A frame of
  /// the window never waits long for them.
  void advance(Show& show, double seconds);

  const ReplayReport& report() const { return report_; }
  /// Returns the first difference, or why the replay could not go on.
  const Status& outcome() const { return outcome_; }

 private:
  void carry_out(const ToggleReplayPause& asked);
  void carry_out(const ToggleReplayLoop& /*asked*/) { report_.loops = !report_.loops; }
  void carry_out(const StepReplay& asked);
  void carry_out(const SeekReplay& asked) { go_to(static_cast<std::int64_t>(asked.frame)); }
  void carry_out(const SetReplaySpeed& asked) { report_.speed = asked.speed; }
  void go_to(std::int64_t frame);
  void play(Show& show, double seconds);
  void seek(Show& show);
  void step(Show& show);
  void begin_anew(Show& show);
  void end_with(const Status& outcome);

  Replay& replay_;
  ReplayReport report_;
  double due_ = 0;  // seconds of the recording that are to be repeated
  Status outcome_ = Done{};
};

}  // namespace throng::app
