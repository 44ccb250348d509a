#pragma once

#include <cstdint>
#include <span>
#include <type_traits>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "engine/anim/base/units.h"
#include "engine/anim/kernel/pose/pose_view.h"
#include "engine/anim/rig/ragdoll_rig.h"

namespace throng::anim {

/// A rag-doll (paper 2.2.6): rigid bodies on joints, by position-based dynamics with small steps (Mueller et al.,
/// "Detailed Rigid Body Simulation with Extended Position Based Dynamics", 2020). Everything is in the model space that
/// the character had when it fell: its placement must stay while the rag-doll lasts. Lengths are the model's, +Y is up.
///
/// All functions are pure and allocate nothing. They give the same bits on every machine.

/// The step by which time goes on, whatever the frames are: 120 a second.
inline constexpr Ticks ragdoll_step_ticks = ticks_per_second / 120;

struct RagdollBodyState {
  glm::vec3 position{0.0F};                    ///< place of the centre of mass
  glm::quat rotation{1.0F, 0.0F, 0.0F, 0.0F};  ///< model-space motion from the bind pose
  glm::vec3 velocity{0.0F};
  glm::vec3 angular_velocity{0.0F};  ///< model space, radians a second
};

/// The whole state between two frames, in plain bytes that may be copied and moved.
struct RagdollState {
  RagdollBodyState bodies[max_ragdoll_bodies];  ///< states at and above the rig's count are not used
  Ticks unspent{};                              ///< time given but not yet simulated, below a step
  std::int32_t quiet_steps = 0;                 ///< steps in a row with almost no movement
  std::int32_t asleep = 0;                      ///< 1: nothing moves until a push or wake_ragdoll
};
static_assert(std::is_trivially_copyable_v<RagdollState> && sizeof(RagdollState) <= 1024);

/// The ground near a body: all points p with dot(normal, p) = height.
struct GroundPlane {
  glm::vec3 normal{0.0F, 1.0F, 0.0F};  ///< unit
  float height = 0.0F;
};

/// The movement of a character when it became a rag-doll.
struct RagdollStart {
  PoseView before{};  ///< the pose `elapsed` ago; may be the same as `now`
  PoseView now{};
  Ticks elapsed{};           ///< 0: it starts without movement of its own
  glm::vec3 velocity{0.0F};  ///< velocity of the character as a whole, beside what its poses do
};

/// Takes over pose and movement. Bones between two bodies go to the bind pose, and so do bones that the view lacks.
void ragdoll_from_pose(const RagdollRig& rig, const RagdollStart& start, RagdollState& state);

/// Moves the rag-doll on. `ground` is one plane for all, or one for each body. `elapsed` is at least 0; however it is
/// split over calls, the bits are the same. A sleeping rag-doll does not notice when the ground changes.
void ragdoll_step(const RagdollRig& rig, std::span<const GroundPlane> ground, Ticks elapsed, RagdollState& state);

/// Writes the bones that have bodies and those between them; others keep their pose. Positions are those of the bind
/// pose, except for the first body, so bones keep their lengths.
void ragdoll_to_pose(const RagdollRig& rig, const RagdollState& state, const PoseView& pose);

/// Pushes a body with an impulse (kg m/s, finite) at a point in model space. Speeds are held below 30 m/s and 40 rad/s.
void push_ragdoll(const RagdollRig& rig, int body, const glm::vec3& impulse, const glm::vec3& point,
                  RagdollState& state);

void wake_ragdoll(RagdollState& state);

}  // namespace throng::anim
