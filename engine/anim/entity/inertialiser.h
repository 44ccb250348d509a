#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/kernel/pose/offset.h"

namespace throng::anim {

/// Follows one source and smooths every change to another. It shows the new source at once, plus an offset to the pose
/// shown before, which decays (kernel/pose/offset.h). It never reads more than two sources, however often it is
/// interrupted, and its pose never jumps.
///
///     [header 96 | inertialiser 32 | transforms if resident | packets x ( float [6][16] offsets, [6][16] velocities )]
///
/// A change takes two updates, since a velocity needs two offsets. In these it reads both sources and shows the old
/// one.
///
///     following --retarget()--> first --> second --> following, offset decaying
struct alignas(64) Inertialiser {
  enum class Capture : std::uint32_t { none, first, second };

  AnimationStateHeader state;  //   0
  Handle target;               //  96  the source that it follows
  Handle leaving;              // 100  the source that it followed before; read while a change is captured
  Ticks since_capture;         // 104
  float half_life;             // 112  seconds in which an offset halves
  float old_half_life;         // 116  half-life of the old offset, which decays until a new one is captured
  Capture capture;             // 120  the work of the next update
  std::uint16_t settled;       // 124  1 between the two updates of a capture, in which the old offset does not decay
  std::uint16_t captured;      // 126  packets that have offsets; a finer level that comes later has more packets
};
static_assert(sizeof(Inertialiser) == entity_header_bytes);
static_assert(offsetof(Inertialiser, since_capture) == 104 && offsetof(Inertialiser, capture) == 120);

/// Returns the half-life in seconds for an interruption that is to settle in `fade`: little is left after four.
inline float half_life_of(Ticks fade) { return static_cast<float>(to_seconds(fade) / 4.0); }

/// Makes it follow `target` from the next update on. `leaving` is the source that it followed, or the source that
/// was shown before there was an inertialiser. The caller destroys both.
void retarget(Inertialiser& inertialiser, Handle target, Handle leaving, float half_life);

/// Returns true once the change is captured and `leaving` is no longer read.
inline bool has_left(const Inertialiser& inertialiser) { return inertialiser.capture == Inertialiser::Capture::none; }

/// Returns true once the offset has ended and the pose has the target's bits.
bool is_over(const Inertialiser& inertialiser);

extern const EntityKind inertialiser_kind;

}  // namespace throng::anim
