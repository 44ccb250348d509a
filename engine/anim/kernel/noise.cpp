#include "engine/anim/kernel/noise.h"

#include "engine/anim/base/hash.h"

namespace throng::anim {

namespace {

/// As std::floor, which is a call where the machine need not have it.
std::int64_t whole_part(double value) {
  const auto towards_zero = static_cast<std::int64_t>(value);
  return towards_zero - (static_cast<double>(towards_zero) > value ? 1 : 0);
}

}  // namespace

NoisePoint noise_at(Ticks time, float frequency) {
  const auto rate = static_cast<double>(frequency);
  const Ticks seconds = time / ticks_per_second;
  const double in_seconds = static_cast<double>(seconds) * rate;  // exact for 17 years
  const double in_rest = to_seconds(time % ticks_per_second) * rate;
  const std::int64_t points = whole_part(in_seconds);
  const double beyond = (in_seconds - static_cast<double>(points)) + in_rest;
  const std::int64_t more_points = whole_part(beyond);
  return {points + more_points, static_cast<float>(beyond - static_cast<double>(more_points))};
}

NoiseMoment noise_moment(std::uint64_t seed, const NoisePoint& point) {
  const float t = point.fraction;
  NoiseMoment moment{.keys = {}, .shares = {0.5F * (1.0F - t) * (1.0F - t), 0.5F + t * (1.0F - t), 0.5F * t * t}};
  for (std::size_t i = 0; i < moment.keys.size(); ++i) {
    moment.keys[i] = static_cast<std::uint32_t>(chain_hash(seed, static_cast<std::uint64_t>(point.lattice) + i));
  }
  return moment;
}

}  // namespace throng::anim
