#pragma once

#include <algorithm>
#include <cmath>

#include "engine/anim/entity/ease_blender.h"

namespace throng::anim {

/// The weight of what a tweak does, 0 to 1, on its way from one value to another. All zero: a weight of 0.
struct FadingWeight {
  float from;
  float to;
  float elapsed;  ///< seconds, some way beyond `total`; below 0: the fade has not begun where the entity stands
  float total;    ///< seconds; 0: at `to`
};
static_assert(sizeof(FadingWeight) == 16);

inline float value(const FadingWeight& weight) {
  if (weight.elapsed >= weight.total) return weight.to;
  if (weight.elapsed <= 0.0F) return weight.from;
  return std::lerp(weight.from, weight.to, ease(weight.elapsed / weight.total));
}

inline constexpr float weight_memory = 2.0F;  ///< seconds after a fade in which it can still be wound back

/// `seconds` below 0 wind it back.
inline void advance_weight(FadingWeight& weight, float seconds) {
  weight.elapsed = std::min(weight.elapsed + seconds, weight.total + weight_memory);
}

/// From where it is. `lead`: how far the entity stands ahead of the moment at which the fade begins.
inline void fade_to(FadingWeight& weight, float to, float seconds, float lead) {
  weight = {.from = value(weight), .to = to, .elapsed = std::min(lead, seconds + weight_memory), .total = seconds};
}

}  // namespace throng::anim
