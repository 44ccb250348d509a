#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/anim/entity/entity_kind.h"

namespace throng::anim {

/// Lays the difference between `layer` and `reference` over `base`: a breath over any stance, a lean over any walk. The
/// three may be entities of any kind. The reference is usually the layer's clip at its first frame.
///
///     [header 96 | layer 32 | transforms if resident]
struct alignas(64) AdditiveLayer {
  AnimationStateHeader state;  //   0
  Handle base;                 //  96
  Handle layer;                // 100
  Handle reference;            // 104
  float weight;                // 108  0 to 1, of the last update
  float target_weight;         // 112  where the weight is moving to
  float weight_per_second;     // 116  0: at once
  std::int16_t mask;           // 120  bone weights, or EaseBlender::no_mask
  std::uint8_t reserved[6];    // 122
};
static_assert(sizeof(AdditiveLayer) == entity_header_bytes);
static_assert(offsetof(AdditiveLayer, weight) == 108 && offsetof(AdditiveLayer, mask) == 120);

extern const EntityKind additive_layer_kind;

}  // namespace throng::anim
