#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/kernel/pose/noise.h"

namespace throng::anim {

/// Turns bones a little and smoothly, so that a character does not stand like a statue. Paper 2.1.2: "Animation noise
/// will be a good example of a post processing behaviour."
///
///     [header 96 | noise 32 | transforms if resident]
struct alignas(64) NoiseMaker {
  static constexpr EntityType entity_type = EntityType::noise_maker;

  AnimationStateHeader state;  //   0
  Ticks time;                  //  96
  Handle source;               // 104
  float frequency;             // 108  Hz, 0 or more
  float amplitude;             // 112  radians, 0 to pi
  std::uint32_t seed;          // 116
  std::int16_t mask;           // 120  each bone's share of the amplitude, or EaseBlender::no_mask: all of it
  std::uint8_t reserved[6];    // 122
};
static_assert(sizeof(NoiseMaker) == entity_header_bytes);
static_assert(offsetof(NoiseMaker, source) == 104 && offsetof(NoiseMaker, mask) == 120);

extern const EntityKind noise_maker_kind;

}  // namespace throng::anim
