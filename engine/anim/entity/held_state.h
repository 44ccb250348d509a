#pragma once

#include "engine/anim/entity/entity_kind.h"

namespace throng::anim {

/// The plain animation state (paper 2.2.1). A host writes its transforms between frames, and they stay. It serves as a
/// source like any other entity.
///
///     [header 96 | 32 unused | transforms, always]
struct alignas(64) HeldState {
  AnimationStateHeader state;
};
static_assert(sizeof(HeldState) == entity_header_bytes);

extern const EntityKind held_state_kind;

}  // namespace throng::anim
