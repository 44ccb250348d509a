#include "engine/anim/kernel/pose/noise.h"

#include <algorithm>

#include "engine/base/hash.h"

namespace throng::anim {

NoisePoint noise_at(Ticks time, float frequency) {
  __extension__ using Wide = __int128;
  const double points_a_second =
      std::min(static_cast<double>(frequency), 0.5 * static_cast<double>(ticks_per_second.count()));
  // In fixed point, which does not wait for one conversion after the other: 32 bits below the point, and 63.
  const auto of_seconds = static_cast<std::int64_t>(points_a_second * 0x1p32);
  const auto of_ticks =
      static_cast<std::int64_t>(points_a_second * (0x1p63 / static_cast<double>(ticks_per_second.count())));
  const std::int64_t seconds = time / ticks_per_second;
  const Ticks rest = time % ticks_per_second;
  const Wide points = static_cast<Wide>(seconds) * of_seconds + (static_cast<Wide>(rest.count()) * of_ticks >> 31);
  const auto fraction = static_cast<std::uint32_t>(points) >> 8U;  // as many bits as a float has
  return {static_cast<std::int64_t>(points >> 32), static_cast<float>(fraction) * 0x1p-24F};
}

NoiseMoment noise_moment(std::uint64_t seed, const NoisePoint& point, float amplitude) {
  constexpr float half_axis_share = 0.288675135F;  // 1 / sqrt(12): three axes at their ends make half of the amplitude
  const float whole = amplitude * (half_axis_share * 0x1p-31F), half = 0.5F * whole;
  const float t = point.fraction, u = 1.0F - t;
  NoiseMoment moment{
      .keys = {}, .shares = {half * u * u, half + whole * (t * u), half * t * t}, .amplitude = amplitude};
  for (std::size_t i = 0; i < moment.keys.size(); ++i) {
    const std::uint64_t key = chain_hash(seed, static_cast<std::uint64_t>(point.lattice) + i);
    moment.keys[i] = folded(static_cast<std::uint32_t>(key));
  }
  return moment;
}

}  // namespace throng::anim
