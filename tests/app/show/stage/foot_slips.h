#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "tests/app/show/stage/posed_feet.h"

namespace throng::app {

/// Measures how far feet slip while they stand, step by step. A step is a time in which the ball of a foot is within a
/// centimetre and a half of where it stands; its slip is the farthest that the ball gets from where the step began, in
/// millimetres. Steps of less than a tenth of a second are none.
class FootSlips {
 public:
  explicit FootSlips(const anim::Skeleton& skeleton) : posed_(skeleton) {}

  /// Looks at a frame of `seconds`. Call it after each pose.
  void add_frame(const Stage& stage, const KeptPages& pages, double seconds) {
    standing_.resize(stage.crowd().size() * PosedFeet::feet);
    const auto absent = absent_of(stage.crowd());
    for (std::uint32_t agent = 0; agent < stage.crowd().size(); ++agent) {
      for (std::size_t foot = 0; foot < PosedFeet::feet; ++foot) {
        const bool is_there = absent.empty() || absent[agent] == 0;
        const auto ball = is_there ? posed_.ball(stage, pages, agent, foot) : std::nullopt;
        follow(standing_[agent * PosedFeet::feet + foot], ball, seconds);
      }
    }
  }

  /// Returns the slips of all steps so far, ascending.
  std::vector<double> slips() const {
    std::vector<double> all = slips_;
    std::ranges::sort(all);
    return all;
  }

 private:
  static constexpr double stands_below = 0.015;  // metres
  static constexpr double shortest_step = 0.1;   // seconds

  struct Standing {
    bool stands = false;
    double x = 0.0, z = 0.0, seconds = 0.0, slip = 0.0;
  };

  void follow(Standing& foot, const std::optional<PosedFeet::Ball>& ball, double seconds) {
    const bool stands = ball && ball->lift < stands_below;
    if (!stands) {
      if (foot.stands && foot.seconds >= shortest_step) slips_.push_back(1000.0 * foot.slip);
      foot = {};
    } else if (!foot.stands) {
      foot = {.stands = true, .x = ball->x, .z = ball->z};
    } else {
      foot.seconds += seconds;
      foot.slip = std::max(foot.slip, std::hypot(ball->x - foot.x, ball->z - foot.z));
    }
  }

  PosedFeet posed_;
  std::vector<Standing> standing_;  // [agent][foot]
  std::vector<double> slips_;
};

/// Returns the slip that so large a share of ascending slips does not exceed; 0 without any.
inline double slip_at(const std::vector<double>& slips, double share) {
  if (slips.empty()) return 0.0;
  return slips[std::min(static_cast<std::size_t>(share * static_cast<double>(slips.size())), slips.size() - 1)];
}

}  // namespace throng::app
