#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/anim/entity/entity_kind.h"

namespace throng::anim {

/// Mixes up to eight sources, each with a weight (paper 2.2.4: "blenders and mixers").
///
///     [header 96 | mixer 32 | transforms if resident | sources and weights 64]
struct alignas(64) Mixer {
  AnimationStateHeader state;       //   0
  std::uint32_t source_count;       //  96  1 to max_sources
  std::int16_t masks[max_sources];  // 100  bone weights of each source, or EaseBlender::no_mask
  std::uint8_t reserved[12];        // 116
};
static_assert(sizeof(Mixer) == entity_header_bytes);
static_assert(offsetof(Mixer, masks) == 100);

struct MixerSources {
  Handle sources[max_sources];  //  0  mixed in this order
  float weights[max_sources];   // 32  0 or more; their sum is not 0
};
static_assert(sizeof(MixerSources) == 64);

inline MixerSources& mixer_sources(std::byte* block, const EntityLayout& layout) {
  return *reinterpret_cast<MixerSources*>(block + layout.private_offset);
}

extern const EntityKind mixer_kind;

}  // namespace throng::anim
