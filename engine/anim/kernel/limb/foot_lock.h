#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <glm/vec3.hpp>

namespace throng::anim {

/// Keeps a planted foot where it came down until it is lifted or its leg no longer reaches. This is its state from
/// frame to frame, in world space, in rows of four floats:
///
///      0           12             16            28     32            44                 48               60
///     [ place     | released_for | normal      | slid | offset      | standing_seconds | last_ball      | flags ]
struct alignas(16) FootLock {
  static constexpr float long_ago = 1e9F;  ///< seconds
  static constexpr std::uint32_t is_locked = 1;
  static constexpr std::uint32_t is_overstretched = 2;  ///< released although planted; locks after the next step
  static constexpr std::uint32_t is_standing = 4;       ///< was planted last frame
  static constexpr std::uint32_t is_stepping = 8;       ///< released although planted, because its leg did not reach;
                                                        ///< locks when it is back

  glm::vec3 place{0.0F};               ///< locked: point of the ground below the ball of the foot
  float released_for = long_ago;       ///< seconds since its release
  glm::vec3 normal{0.0F, 1.0F, 0.0F};  ///< normal of the ground there
  float slid = 0.0F;                   ///< metres that the ball went over the ground since the foot came down
  glm::vec3 offset{0.0F};              ///< released: distance of the foot from its pose; fades out
  float standing_seconds = 0.0F;       ///< since the foot came down
  glm::vec3 last_ball{0.0F};
  std::uint32_t flags = 0;

  bool locked() const { return (flags & is_locked) != 0; }
};
inline constexpr int foot_lock_rows = 4;  ///< rows of four floats
static_assert(sizeof(FootLock) == 64 && offsetof(FootLock, normal) == 16 && offsetof(FootLock, offset) == 32);
static_assert(offsetof(FootLock, last_ball) == 48 && offsetof(FootLock, flags) == 60);
static_assert(std::is_trivially_copyable_v<FootLock>);

/// A planted foot that its leg no longer holds steps back to its pose this share of the way high.
inline constexpr float step_height = 0.25F;

struct FootLockOptions {
  float release_seconds = 0.2F;  ///< the time that a released foot takes to return to its pose
  float farthest = 0.4F;         ///< metres from its pose at which a planted foot is released
  bool enabled = true;
};

/// The plane of ground that a foot stands on.
struct Footing {
  glm::vec3 place{0.0F};
  glm::vec3 normal{0.0F, 1.0F, 0.0F};
};

/// Returns whether a foot can stand there: the normal is unit to a hundredth, and faces up.
bool is_valid(const Footing& footing);

/// Returns the height of the plane through a footing at (x, z).
inline float ground_height(const Footing& footing, float x, float z) {
  return footing.place.y -
         ((x - footing.place.x) * footing.normal.x + (z - footing.place.z) * footing.normal.z) / footing.normal.y;
}

}  // namespace throng::anim
