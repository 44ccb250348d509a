#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/kernel/pose/offset.h"

namespace throng::anim {

/// Follows one source and smooths every change of it: the new source is taken at once, and what it lacks to the old one
/// is added and decays (kernel/pose/offset.h). However often it is interrupted it never reads more than two sources,
/// and nothing snaps.
///
///     [header 96 | inertialiser 32 | transforms if resident | packets x ( float [6][16] offsets, [6][16] velocities )]
///
/// A change takes two updates, since a velocity needs two offsets: both sources are read and the old one is shown.
///
///     following --retarget()--> first --> second --> following, offset decaying
struct alignas(64) Inertialiser {
  enum class Capture : std::uint32_t { none, first, second };

  AnimationStateHeader state;  //   0
  Handle target;               //  96  what is followed
  Handle leaving;              // 100  what was followed before: read while a change is captured
  Ticks since_capture;         // 104
  float half_life;             // 112  seconds in which an offset halves
  float old_half_life;         // 116  of the offset that decays until a new one is captured
  Capture capture;             // 120  what the next update does
  std::uint16_t settled;       // 124  1 between the halves of a capture: the old offset stands still
  std::uint16_t captured;      // 126  packets that have offsets: bones of a finer level that comes later have none
};
static_assert(sizeof(Inertialiser) == entity_header_bytes);
static_assert(offsetof(Inertialiser, since_capture) == 104 && offsetof(Inertialiser, capture) == 120);

/// Follows `target` from the next update on; `leaving` is what was followed up to now, or what was shown before there
/// was an inertialiser. Both are the caller's to destroy.
void retarget(Inertialiser& inertialiser, Handle target, Handle leaving, float half_life);

/// The change is captured: `leaving` is read no more.
inline bool has_left(const Inertialiser& inertialiser) { return inertialiser.capture == Inertialiser::Capture::none; }

/// The offset has ended: the pose is the target's, to the bit.
bool is_over(const Inertialiser& inertialiser);

extern const EntityKind inertialiser_kind;

}  // namespace throng::anim
