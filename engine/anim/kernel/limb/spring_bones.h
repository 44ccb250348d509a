#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>

#include "engine/anim/kernel/limb/joint_chain.h"
#include "engine/anim/kernel/pose/pose_view.h"
#include "engine/anim/rig/spring_rig.h"

namespace throng::anim {

/// The end of a bone that swings, in world space.
struct SpringJointState {
  glm::vec3 tail{0.0F};
  glm::vec3 velocity{0.0F};  ///< metres a second
  glm::vec3 head{0.0F};      ///< its joint
};

/// The state that the springs of a character share.
struct SpringBody {
  // The owner sets these three.
  JointMotion model_in_world{};
  float ground = -std::numeric_limits<float>::infinity();  ///< the height that no bone falls below, world space
  std::uint32_t restarts = 0;                              ///< another number than before: starts anew, as after a cut
  // These are results of the last update.
  std::uint32_t restarted = 0;
  bool started = false;  ///< was updated
};
static_assert(std::is_trivially_copyable_v<SpringJointState> && std::is_trivially_copyable_v<SpringBody>);

/// The longest step of the springs, seconds. A frame is cut into the fewest equal steps that are no longer.
inline constexpr float spring_step_seconds = 1.0F / 120.0F;
/// The longest time between two updates, seconds. After a longer one springs start anew, at rest.
inline constexpr float longest_spring_seconds = 0.5F;

/// Chains of bones that follow the pose on springs: hair, skirts, tails. The end of each bone is a point that is pulled
/// to where the pose has it, by gravity, and out of colliders; its distance from its joint stays. Damped springs are
/// integrated by implicit Euler steps, stable for any stiffness, and lengths by position-based dynamics (M. Mueller et
/// al., "Position Based Dynamics", 2007). In between two updates the joints that carry chains, and colliders, are
/// interpolated. So a chain on a body that moves smoothly is where it would be without skipped updates: to a
/// hundredth of its swing with 20 updates a second, to a twentieth with 10.
///
/// It is pure, allocates nothing, and gives the same bits on every machine. A new or restarted character is at rest
/// in its pose. Levels of detail without all bones are left alone, and forget.
struct SpringBonesJob {
  const SpringRig* rig = nullptr;
  SpringBody* body = nullptr;
  std::span<JointMotion> carriers;     ///< [chains, then colliders]: their carriers at the last update, world space
  std::span<SpringJointState> joints;  ///< [rig->joints]
  PoseView pose;
  float seconds = 0.0F;  ///< since the last frame, not negative
  float weight = 1.0F;   ///< 0 leaves the pose to the bit and forgets all state
};
bool is_valid(const SpringBonesJob& job);

void swing_bones(const SpringBonesJob& job);

}  // namespace throng::anim
