#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "engine/anim/base/pose.h"
#include "engine/anim/base/units.h"

namespace throng::anim {

enum class EntityType : std::uint32_t {
  state,
  sampled_player,
  keyframe_player,
  ease_blender,
  mixer,
  additive_layer,
  inertialiser,
  noise_maker,
  look_at,
  foot_placement,
  two_bone_ik,
  ragdoll,
  spring_bones,
  chain_reach,
  socket,
  user
};

/// Every low-level entity is one relocatable block that begins with this header (paper 2.2.1):
///
///     byte 0                64                   128
///     +---------------------+--------------------+------------------+----------------+
///     | identity            | what a frame       | transforms       | private part   |
///     | (written once)      | changes            | (resident only)  | (keyframes)    |
///     +---------------------+--------------------+------------------+----------------+
///     '-- AnimationStateHeader, 96 bytes, then 32 bytes of the derived entity --'
///
/// A *resident* block has its transforms at `transforms_offset`. A *transient* block has none, and its offset is 0: the
/// `fused` schedule lays its transforms out in the local store, writes back the second line alone, and fetches the
/// first line only for kinds that read it (EntityKind::reads_identity). `total_size` and `transforms_offset` are enough
/// to move a block and to use it as an animation state.
struct AnimationStateHeader {
  static constexpr std::uint16_t has_absolute_root = 1;  ///< the absolute root is meant

  // System information
  EntityType type;                  //  0
  std::uint32_t total_size;         //  4  bytes, a multiple of 64
  std::uint32_t transforms_offset;  //  8  bytes from the start of the block, 0: transient
  // Animated entity information
  std::uint16_t bone_count;  // 12
  std::int16_t priority;     // 14  players have the highest; a blender the lowest of its sources minus one
  // Absolute root, for cut scenes and pre-canned sequences: where in the world the state begins
  double absolute_position[3];  // 16  metres
  float absolute_rotation[4];   // 40  quaternion x y z w
  std::uint32_t owner;          // 56  the agent it belongs to
  std::uint16_t components;     // 60  floats a bone takes in the transforms, 7 or 10
  std::uint16_t flags;          // 62
  // --- what a frame changes ---
  Ticks delta_time;  // 64  elapsed since the last update; set before the update, used up by it
  // Velocity, to move the animated entity, in its own space
  float linear_velocity[3];   // 72  metres a second
  float angular_velocity[3];  // 84  radians a second
};

inline constexpr std::size_t identity_bytes = 64;        ///< first bytes of a block, which no update changes
inline constexpr std::size_t entity_header_bytes = 128;  ///< the header and the derived entity's 32 bytes
inline constexpr std::int16_t highest_priority = INT16_MAX;

static_assert(sizeof(AnimationStateHeader) == 96, "the rest of the second line is the derived entity's");
static_assert(offsetof(AnimationStateHeader, bone_count) == 12);
static_assert(offsetof(AnimationStateHeader, absolute_position) == 16);
static_assert(offsetof(AnimationStateHeader, owner) == 56);
static_assert(offsetof(AnimationStateHeader, flags) == 62);
static_assert(offsetof(AnimationStateHeader, delta_time) == identity_bytes);
static_assert(offsetof(AnimationStateHeader, angular_velocity) == 84);
static_assert(std::is_trivially_copyable_v<AnimationStateHeader>);

/// Returns the transforms of a block: float [packet][components][16], see pose.h. The block must be resident.
inline float* transforms_of(AnimationStateHeader& state) {
  return reinterpret_cast<float*>(reinterpret_cast<std::byte*>(&state) + state.transforms_offset);
}
inline const float* transforms_of(const AnimationStateHeader& state) {
  return reinterpret_cast<const float*>(reinterpret_cast<const std::byte*>(&state) + state.transforms_offset);
}

}  // namespace throng::anim
