#pragma once

#include <algorithm>

#include "engine/anim/base/units.h"

namespace throng::anim {

/// A weight, 0 to 1, that moves evenly to `target` and stays there. The time since its end says all, so it does not
/// depend on when its agent was posed.
struct LinearWeight {
  float target;
  float per_second;  ///< 0: the weight is `target`
};

/// Returns the weight at a time since its end; below 0 it still moves.
inline float value(const LinearWeight& weight, Ticks since_end) {
  if (since_end >= Ticks{}) return weight.target;
  const auto seconds = static_cast<float>(to_seconds(since_end));
  return std::clamp(weight.target + weight.per_second * seconds, 0.0F, 1.0F);
}

}  // namespace throng::anim
