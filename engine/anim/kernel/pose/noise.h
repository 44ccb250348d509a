#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/anim/base/pose.h"
#include "engine/anim/base/units.h"

namespace throng::anim {

/// A time, relative to the lattice points of noise.
struct NoisePoint {
  std::int64_t lattice = 0;
  float fraction = 0.0F;  ///< 0 to 1
};

/// Returns the point at a time. `frequency` is lattice points a second, 0 or more; above half a point a tick it is
/// taken for that. Whole seconds and the rest are kept apart, so the fraction is as exact after years as it is at
/// first. Negative times are as good as others.
NoisePoint noise_at(Ticks time, float frequency);

/// Returns the bits with their upper half mixed into the lower one: folded(a ^ b) is folded(a) ^ folded(b).
constexpr std::uint32_t folded(std::uint32_t bits) { return bits ^ (bits >> 16); }

/// Data that all bones of a character share at one time: three lattice points, and the share of each in a uniform
/// quadratic B-spline.
struct NoiseMoment {
  std::array<std::uint32_t, 3> keys{};  ///< folded
  std::array<float, 3> shares{};        ///< half the turn, rad, for a value of 1; values are -2^31 to 2^31
  float amplitude = 0.0F;               ///< rad, 0 to pi: no turn is ever larger
};
NoiseMoment noise_moment(std::uint64_t seed, const NoisePoint& point, float amplitude);

/// Noise: turns bones a little, out = from * rotation, smoothly (its velocity has no jumps) and always the same at the
/// same time. Each axis of each bone has a value from -1 to 1 at every lattice point, ten bits and more of an integer
/// hash of seed, bone and point; between them runs the spline. With v the values times amplitude / sqrt(3), the bone
/// turns about v by 2 atan(|v| / 2). A bone of amplitude 0 keeps its bits. `out` may be `from`.
struct ShakenBones {
  const float* from;          ///< [components][16]
  float* out;                 ///< [components][16]
  const NoiseMoment* moment;  ///< the character's moment
  const float* bone_weights;  ///< [16], 0 to 1, each bone's share of the amplitude, or null: all 1
};
struct NoiseJob {
  std::span<const ShakenBones> characters;
  int packet = 0;      ///< number of the packet that these 16 bones are
  int bone_count = 0;  ///< bones of the whole pose; bones at and above it keep their bits
  int components = rigid_components;
};
bool is_valid(const NoiseJob& job);

}  // namespace throng::anim
