#include "engine/anim/kernel/noise.h"

#include <cmath>

namespace throng::anim {

NoisePoint noise_at(Ticks time, float frequency) {
  const auto rate = static_cast<double>(frequency);
  const Ticks seconds = time / ticks_per_second;
  const double in_seconds = static_cast<double>(seconds) * rate;  // exact for 17 years
  const double in_rest = to_seconds(time % ticks_per_second) * rate;
  const double points = std::floor(in_seconds);
  const double beyond = (in_seconds - points) + in_rest;
  const double more_points = std::floor(beyond);
  return {static_cast<std::int64_t>(points) + static_cast<std::int64_t>(more_points),
          static_cast<float>(beyond - more_points)};
}

}  // namespace throng::anim
