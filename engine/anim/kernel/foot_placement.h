#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

#include <glm/vec3.hpp>

#include "engine/anim/base/result.h"
#include "engine/anim/kernel/foot_lock.h"
#include "engine/anim/kernel/joint_chain.h"
#include "engine/anim/kernel/pose_view.h"
#include "engine/anim/kernel/smooth_damp.h"
#include "engine/anim/kernel/two_bone_ik.h"

namespace throng::anim {

inline constexpr int max_legs = 8;

/// Bones of one leg, by index.
struct LegBones {
  int hip = -1;
  int knee = -1;
  int ankle = -1;
  int toe = -1;  ///< ball of the foot; -1: the sole is the point below the ankle
};

struct PlacedLeg {
  TwoBoneLimb limb;
  std::array<glm::vec3, 2> sole{};  ///< heel and ball, metres from the ankle, bind pose; the same point without a toe
};

/// The legs of a character and the joint that carries them all. Made at load, shared by every character of the
/// skeleton.
struct FootPlacementRig {
  int leg_count = 0;
  int pelvis = 0;  ///< place in every leg's chain: the lowest joint above all hips
  std::array<PlacedLeg, max_legs> legs{};
};
static_assert(std::is_trivially_copyable_v<FootPlacementRig>);

/// `sole_height` is the height of the soles in the bind pose, model space, metres: 0 where the model stands on the
/// origin; `forward` is where it faces. Refused: no legs or more than max_legs, legs that no joint carries, and what
/// make_two_bone_limb refuses.
Result<FootPlacementRig> make_foot_placement_rig(const Skeleton& skeleton, std::span<const LegBones> legs,
                                                 float sole_height = 0.0F,
                                                 const glm::vec3& forward = {0.0F, 0.0F, 1.0F});

/// A foot counts as planted by how high the pose has the lowest point of its sole: see down_below and up_above.
inline constexpr float planted_by_pose = -1.0F;

/// Metres as for a person of 1.8 m: scale them with the character.
struct FootPlacementOptions {
  float down_below = 0.012F;          ///< a sole no higher than this is down for certain,
  float up_above = 0.03F;             ///< one as high as this is up
  float max_drop = 0.4F;              ///< metres that the pelvis may be lowered
  float drop_smooth_seconds = 0.08F;  ///< see smooth_damp
  float most_gap = 0.005F;            ///< metres that the pelvis may lag behind what planted feet need, ...
  float fastest_drop = 1.5F;          ///< ... if metres a second of this are enough
  float least_tilt_cosine = 0.76F;    ///< feet follow slopes up to this angle (40 degrees)
  FootLockOptions lock{};
};

/// What an entity keeps from frame to frame. A new one starts without easing.
struct FootPlacementState {
  std::array<FootLock, max_legs> feet{};
  DampedValue drop;
  bool started = false;
};
static_assert(std::is_trivially_copyable_v<FootPlacementState>);

/// Puts feet on uneven ground: what the pose does over flat ground at height 0, it does over the ground given. Feet
/// keep their height above it, tilted with it; planted ones touch it with the lowest point of the sole and stay where
/// they came down; the pelvis is lowered for the legs to reach.
struct FootPlacementJob {
  const FootPlacementRig* rig = nullptr;
  FootPlacementState* state = nullptr;
  PoseView pose;
  std::span<const GroundContact> contacts;  ///< one a leg: model space, under the ankle as the pose has it
  std::span<const float> planted;           ///< one a leg, 0 (in the air) to 1 (on the ground), or planted_by_pose
  JointMotion model_in_world{};             ///< turned about the vertical only
  float seconds = 0.0F;                     ///< since the last frame, not negative
  float weight = 1.0F;                      ///< 0 leaves the pose to the bit and forgets the state
  FootPlacementOptions options{};
};

struct FootPlacementResult {
  float drop = 0.0F;                        ///< metres that the pelvis was lowered
  std::array<float, max_legs> missed_by{};  ///< metres that the ankle is from where it should be, one a leg
};

/// The legs' chains, in model space.
using PosedLegs = std::array<ChainMotion, max_legs>;

/// The legs as the pose has them. False, and nothing is written, where the level of detail lacks a leg.
bool pose_legs(const FootPlacementRig& rig, const PoseView& pose, PosedLegs& legs);

/// Where an ankle is, model space: where to look for the ground.
glm::vec3 ankle_of(const FootPlacementRig& rig, const PosedLegs& legs, std::size_t leg);

/// `legs` are as the pose has them, and follow it.
FootPlacementResult place_feet(const FootPlacementJob& job, PosedLegs& legs);

/// Poses the legs, too. Levels of detail without all of them are left alone.
FootPlacementResult place_feet(const FootPlacementJob& job);

}  // namespace throng::anim
