#pragma once

#include <cstddef>

#include "engine/anim/entity/entity_kind.h"

namespace throng::anim {

EntityLayout entity_layout(const EntityKind& kind, Residency residency, int bone_count, int components);

/// Fills the system information of a new, zeroed block.
void initialise_state(AnimationStateHeader& state, const EntityLayout& layout, int bone_count, int components);

/// Copies a block to the zeroed block of the other residency: all but the transforms, which the next update makes anew.
void convert_residency(const std::byte* from, std::byte* to, const EntityLayout& from_layout,
                       const EntityLayout& to_layout);

}  // namespace throng::anim
