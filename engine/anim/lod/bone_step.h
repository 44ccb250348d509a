#pragma once

#include <cstdint>

namespace throng::anim {

/// The pose of an agent that goes from one bone level to another, so that nothing pops: the bones that come or go pass
/// through a pose in which they stand still, and which both levels show alike.
///
///     to a coarser level:   all of the finer --> half way --> there | the coarser      four updates,
///     and back:             the coarser | there --> half way --> all of the finer      the mesh changes at |
struct BoneStep {
  std::uint8_t level = 0;        ///< the level that is evaluated
  std::uint8_t fade_level = 0;   ///< the bones that this level lacks fade
  std::uint8_t fade_halves = 0;  ///< the halves of the way to where they stand still, 0 to 2

  friend bool operator==(const BoneStep&, const BoneStep&) = default;
};

constexpr BoneStep settled_at(std::uint8_t level) { return {.level = level, .fade_level = level, .fade_halves = 0}; }

/// Returns the step after `now` for an agent that is to be at level `wanted`.
BoneStep next_step(const BoneStep& now, std::uint8_t wanted);

}  // namespace throng::anim
