#pragma once

#include "engine/anim/entity/entity_kind.h"

namespace throng::anim {

/// The animation state itself (paper 2.2.1), derived from nothing: its transforms are what somebody wrote there between
/// frames, and stay. A source like any other.
///
///     [header 96 | 32 unused | transforms, always]
struct alignas(64) HeldState {
  AnimationStateHeader state;
};
static_assert(sizeof(HeldState) == entity_header_bytes);

extern const EntityKind held_state_kind;

}  // namespace throng::anim
