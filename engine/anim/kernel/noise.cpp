#include "engine/anim/kernel/noise.h"

#include "engine/anim/base/hash.h"

namespace throng::anim {

namespace {

/// As std::floor for values below 2^51, which is a call where the machine need not have it.
double whole_part(double value) {
  constexpr double without_fractions = 0x1.8p52;
  const double nearest = (value + without_fractions) - without_fractions;
  return nearest - (nearest > value ? 1.0 : 0.0);
}

}  // namespace

NoisePoint noise_at(Ticks time, float frequency) {
  const auto rate = static_cast<double>(frequency);
  const Ticks seconds = time / ticks_per_second;
  const double in_seconds = static_cast<double>(seconds) * rate;  // exact for 17 years
  const double in_rest = static_cast<double>(time % ticks_per_second) * (rate * to_seconds(1));
  const double points = whole_part(in_seconds);
  const double beyond = (in_seconds - points) + in_rest;
  const double more_points = whole_part(beyond);
  return {static_cast<std::int64_t>(points + more_points), static_cast<float>(beyond - more_points)};
}

NoiseMoment noise_moment(std::uint64_t seed, const NoisePoint& point) {
  const float t = point.fraction;
  NoiseMoment moment{.keys = {}, .shares = {0.5F * (1.0F - t) * (1.0F - t), 0.5F + t * (1.0F - t), 0.5F * t * t}};
  for (std::size_t i = 0; i < moment.keys.size(); ++i) {
    const std::uint64_t key = chain_hash(seed, static_cast<std::uint64_t>(point.lattice) + i);
    moment.keys[i] = folded(static_cast<std::uint32_t>(key));
  }
  return moment;
}

}  // namespace throng::anim
