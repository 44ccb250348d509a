#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <string>

#include "app/settings/quality.h"

namespace throng::app {

/// Returns the time that a frame takes at least by Tuning::frame_limit; 0: there is no limit.
inline std::chrono::nanoseconds least_frame_time(const Tuning& tuning) {
  return tuning.frame_limit > 0 ? std::chrono::nanoseconds(std::chrono::seconds(1)) / tuning.frame_limit
                                : std::chrono::nanoseconds(0);
}

/// Says which values of a PictureCost a person has set by hand.
struct SetByHand {
  bool picture_size = false, triangle_budget = false, shadows = false, crowd_shade = false;
};

/// Holds the frame rate that a person asks for: it goes down picture_costs quickly where frames take too long, and up
/// slowly where there is time to spare. What a person sets by hand stays.
class FrameRateKeeper {
 public:
  /// Begins at the best picture, or in the middle where a `slow` device draws.
  explicit FrameRateKeeper(const SetByHand& by_hand = {}, bool slow = false)
      : by_hand_(by_hand), is_slow_(slow), first_(slow ? picture_costs.size() / 2 : 0), cost_(first_) {}

  /// Takes the milliseconds of a frame's work, without the wait for the screen. Holds nothing unless
  /// Tuning::holds_rate.
  void add_frame(double milliseconds, const Tuning& asked);

  /// Returns the tuning that is asked for, at the cost that holds the rate.
  Tuning kept(Tuning asked) const;
  /// Returns the tuning that is asked for, at the cost of the best picture. What a person set by hand stays, but for
  /// the size: a picture whose values have no name of a quality was set by hand.
  Tuning at_best(Tuning asked) const;
  /// Takes a change that a person made to what kept() returned, and returns what is asked for then. A cost that the
  /// person changed is set by hand from now on, until the person asks for the rate anew.
  Tuning changed(Tuning by_person, const Tuning& asked);

  /// Says in a line what is given up to hold the rate; empty where nothing is.
  std::string given_up(const Tuning& asked) const;
  /// Says in a line that frames are slow and that holding the rate helps; empty while they are not, or the rate is
  /// held.
  std::string advice(const Tuning& asked) const;

 private:
  void go_to(std::size_t cost);
  PictureCost by_hand_or(PictureCost cost, const Tuning& asked) const;
  bool knows_times() const;
  double times(const Tuning& asked) const;

  SetByHand by_hand_;
  bool is_slow_;
  std::size_t first_;  // index into picture_costs
  std::size_t cost_;
  std::array<double, 8> last_{};  // milliseconds; a single slow frame is no reason to change
  std::size_t frames_ = 0;        // since the cost changed
  double seconds_ = 0.0;          // of these frames
  double patience_ = 0.0;         // seconds of spare time before it goes up; 0: the least
  bool went_up_ = false;          // at the last change
};

}  // namespace throng::app
