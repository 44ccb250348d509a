#pragma once

#include <algorithm>
#include <cmath>

#include "engine/anim/entity/ease_blender.h"

namespace throng::anim {

/// The weight of a tweak, 0 to 1, which fades from one value to another. All members zero: a weight of 0.
struct FadingWeight {
  float from;
  float to;
  float elapsed;  ///< seconds since the fade began, up to weight_memory beyond `total`; below 0: it has not begun yet
  float total;    ///< seconds of the fade; 0: the weight is `to`
};
static_assert(sizeof(FadingWeight) == 16);

inline float value(const FadingWeight& weight) {
  if (weight.elapsed >= weight.total) return weight.to;
  if (weight.elapsed <= 0.0F) return weight.from;
  return std::lerp(weight.from, weight.to, ease(weight.elapsed / weight.total));
}

inline constexpr float weight_memory = 2.0F;  ///< seconds after a fade in which it can still be wound back

/// Moves the fade on; `seconds` below 0 wind it back.
inline void advance_weight(FadingWeight& weight, float seconds) {
  weight.elapsed = std::min(weight.elapsed + seconds, weight.total + weight_memory);
}

/// Begins a fade from the present value. `lead`: seconds by which the entity is ahead of the fade's first moment.
inline void fade_to(FadingWeight& weight, float to, float seconds, float lead) {
  weight = {.from = value(weight), .to = to, .elapsed = std::min(lead, seconds + weight_memory), .total = seconds};
}

}  // namespace throng::anim
