#pragma once

#include <type_traits>

#include <glm/vec3.hpp>

namespace throng::anim {

/// The ground under a foot, as its owner found it.
struct GroundContact {
  float height = 0.0F;                 ///< metres, of the ground straight below (or above) the ankle
  glm::vec3 normal{0.0F, 1.0F, 0.0F};  ///< of the ground there, unit, y above 0
};

/// Where a foot stands, and that it stays there until it is lifted. Kept from frame to frame, world space.
struct FootLock {
  static constexpr float long_ago = 1e9F;  ///< seconds
  bool locked = false;
  bool overstretched = false;          ///< let go although it is planted; locks again after the next step
  bool standing = false;               ///< was planted last frame
  float released_for = long_ago;       ///< seconds since it was let go
  glm::vec3 place{0.0F};               ///< locked: point of the ground below the ball of the foot
  glm::vec3 normal{0.0F, 1.0F, 0.0F};  ///< of the ground there
  glm::vec3 offset{0.0F};              ///< let go: how far the foot was from where the pose had it; fades out
  glm::vec3 last_ball{0.0F};
  float slid = 0.0F;              ///< metres that the ball went over the ground since the foot came down
  float standing_seconds = 0.0F;  ///< since then
};
static_assert(std::is_trivially_copyable_v<FootLock>);

struct FootLockOptions {
  bool enabled = true;
  float release_seconds = 0.2F;  ///< a foot that is let go is back where the pose has it after that
  float farthest = 0.4F;         ///< metres from where the pose has it, beyond which a planted foot is let go
};

/// Ground that a foot is to stand on: a point of it, and how it lies there.
struct Footing {
  glm::vec3 place{0.0F};
  glm::vec3 normal{0.0F, 1.0F, 0.0F};
};

/// One step of a lock. `posed` is the footing where the pose has the foot, `planted` 0 to 1: from a half on it locks.
/// Returns the footing to use, all in world space. Never jumps: a foot locks where it is, and what it is away from the
/// pose when it is let go fades out.
Footing step_foot_lock(FootLock& lock, const Footing& posed, float planted, const FootLockOptions& options,
                       float seconds);

/// Adds to `slid` how far the ball of the foot got since the last frame, if it was planted all the while. World space.
void measure_slide(FootLock& lock, const glm::vec3& ball, float planted, float seconds);

/// Height of the plane through a footing at (x, z).
float ground_height(const Footing& footing, float x, float z);

}  // namespace throng::anim
