#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/show/report/swept_value.h"

namespace throng::anim {
class AnimationSystem;
}

namespace throng::app {

/// The cost of posing one frame.
struct UpdateCost {
  double milliseconds = 0;
  std::uint64_t tasks = 0;  ///< handed to PUs
  std::uint64_t bytes = 0;  ///< copied into local stores and out of them
};

/// Returns the cost of the last update.
UpdateCost cost_of_last_update(const anim::AnimationSystem& system);

struct SweepStop {
  double value = 0;
  bool refused = false;
  bool known = false;
  UpdateCost cost = {};  ///< the median of its frames, figure by figure, if it is known
};

/// The results of a sweep so far.
struct SweepCurve {
  SweptValue value = SweptValue::pus;
  std::vector<SweepStop> stops;  ///< values ascend
  int visits = 0, all_visits = 0;
  bool runs = false;
  std::string refusal;  ///< the reason why the first of the refused stops was refused

  bool complete() const { return visits == all_visits; }
  /// Returns the stop at which an update takes least; null while nothing is known.
  const SweepStop* lowest() const;
};

/// Goes through the stops of one value of the tuning while the crowd runs, some frames at each. It does so round after
/// round, so that a drift of the machine's speed meets all stops alike. In each frame it says which tuning to apply,
/// and is told the cost. It changes nothing itself: after it has ended, the caller applies the tuning it began with
/// again.
class TuningSweep {
 public:
  static constexpr int rounds = 5, settling_frames = 2, measured_frames = 3;

  /// Starts a sweep of `value`. All other values stay as they are in `tuning`. `threads` is the machine's number.
  void start(SweptValue value, const Tuning& tuning, int threads);
  void stop() { curve_.runs = false; }
  bool runs() const { return curve_.runs; }
  bool began_with(const Tuning& tuning) const { return tuning == start_; }

  /// Returns the tuning for the next frame. Call it only while the sweep runs.
  Tuning tuning() const;
  /// Notes the reason why tuning() could not be applied. The sweep goes on to another stop, or ends.
  void refuse(const std::string& reason);
  /// Adds the cost of a frame that was posed with tuning().
  void add(const UpdateCost& cost);

  const SweepCurve& curve() const { return curve_; }

 private:
  void go_on();

  Tuning start_;
  SweepCurve curve_;
  std::vector<std::vector<UpdateCost>> measured_;  // [stop]
  std::size_t stop_ = 0;
  int round_ = 0;
  int frames_ = 0;  // frames of this visit
};

}  // namespace throng::app
