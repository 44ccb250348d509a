#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "engine/anim/entity/entity_kind.h"

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

/// Eases from one animation state to another (paper 2.2.4). The sources may be entities of any kind.
///
///     [header 96 | blender 32 | transforms if resident]
struct alignas(64) EaseBlender {
  static constexpr std::uint16_t held = 1;     ///< time does not move the fraction
  static constexpr std::uint16_t linear = 2;   ///< the fraction is `weight`, `elapsed` after its end
  static constexpr std::int16_t no_mask = -1;  ///< every bone takes the whole fraction

  AnimationStateHeader state;  //   0
  Handle from;                 //  96  the paper's "source animation state pointers"
  Handle to;                   // 100
  Ticks elapsed;               // 104
  union {
    Ticks total;          // 112
    LinearWeight weight;  // 112  where it is linear
  };
  std::int16_t mask;    // 120  index of an array of bone weights (2.2.4, footnote 6), or no_mask
  std::uint16_t flags;  // 122
  float fraction;       // 124  of `to`, 0 to 1, of the last update
};
static_assert(sizeof(EaseBlender) == entity_header_bytes);
static_assert(offsetof(EaseBlender, from) == 96 && offsetof(EaseBlender, elapsed) == 104);
static_assert(offsetof(EaseBlender, total) == 112 && sizeof(LinearWeight) == sizeof(Ticks));
static_assert(offsetof(EaseBlender, mask) == 120 && offsetof(EaseBlender, fraction) == 124);

/// Eases in and out: 0 at 0, 1 at 1, level at both ends.
constexpr float ease(float x) { return x * x * (3.0F - 2.0F * x); }

/// Uses up `state.delta_time` and moves the fraction.
void advance_blender(EaseBlender& blender);

extern const EntityKind ease_blender_kind;

}  // namespace throng::anim
