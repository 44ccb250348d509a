#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

#include <glm/vec3.hpp>

#include "engine/anim/kernel/lanes/smooth_damp.h"
#include "engine/anim/kernel/limb/foot_lock.h"
#include "engine/anim/kernel/limb/joint_chain.h"
#include "engine/anim/kernel/limb/two_bone_ik.h"
#include "engine/anim/kernel/pose/pose_view.h"
#include "engine/base/result.h"

namespace throng::anim {

inline constexpr int max_legs = 8;
inline constexpr int most_leg_quads = 64;  ///< quads (pose.h) that the bones of all legs may lie in

/// A share of the leg's length: the pelvis is lowered before a leg is straighter than that.
inline constexpr float knee_reserve = 0.02F;

/// A share of the leg's length: a lock lowers the pelvis by no more than this below the ground's drop. Where the
/// host says when feet stand, it knows how long, and a lock may ask for more.
inline constexpr float lock_reserve = 0.012F, told_lock_reserve = 0.035F;

/// A share of the leg's length: a foot that its host says is in the air is no lower than that over the ground.
inline constexpr float foot_clearance = 0.03F;

/// The bones of one leg, by index.
struct LegBones {
  int hip = -1;
  int knee = -1;
  int ankle = -1;
  int toe = -1;  ///< ball of the foot; -1: the sole is the point below the ankle
};

struct PlacedLeg {
  TwoBoneLimb limb;
  /// The heel, which is the sole below the ankle, and the joint of the toes, metres from the ankle in the bind pose.
  /// The toes stay flat while the heel rises, so the joint keeps its height. Without a toe both are the heel.
  std::array<glm::vec3, 2> sole{};
  float ball_height = 0.0F;  ///< metres of that joint over the sole
};

/// The legs of a character and the joint that carries them all. They are made at load and shared by every character of
/// the skeleton.
struct FootPlacementRig {
  int leg_count = 0;
  int pelvis = 0;    ///< index into every leg's chain: the lowest joint above all hips
  int bone_end = 0;  ///< bones from here on are neither read nor changed
  std::array<PlacedLeg, max_legs> legs{};

  int pelvis_bone() const { return legs.data()->limb.chain.bones.data()[pelvis]; }
};
static_assert(std::is_trivially_copyable_v<FootPlacementRig>);

/// Makes the rig of these legs. `sole_height` is the height of the soles in the bind pose, in metres in model space: 0
/// where the model stands on the origin. `forward` is where it faces. Errors: no legs or more than max_legs, legs that
/// no joint carries, bones in more than most_leg_quads, and those of make_two_bone_limb.
Result<FootPlacementRig> make_foot_placement_rig(const Skeleton& skeleton, std::span<const LegBones> legs,
                                                 float sole_height = 0.0F,
                                                 const glm::vec3& forward = {0.0F, 0.0F, 1.0F});

/// The value with which a foot counts as planted by the height at which the pose has the lowest point of its sole; see
/// down_below and up_above.
inline constexpr float planted_by_pose = -1.0F;

/// The options of foot placement. Metres are for a person of 1.8 m: scale them with the character.
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

bool is_valid(const FootPlacementOptions& options);

/// The state that the feet of a character share, in rows of four floats. A new one starts without easing.
///
///      0                      28        32        72         80
///     [ model in world       | started | options | drop     ]
struct alignas(16) PlacedBody {
  JointMotion model_in_world{};    ///< its owner sets it; turned about the vertical only
  bool started = false;            ///< was updated
  FootPlacementOptions options{};  ///< its owner sets them
  DampedValue drop{};              ///< metres that the pelvis is to be lowered, of the last update
};
inline constexpr int placed_body_rows = 5;
static_assert(sizeof(PlacedBody) == placed_body_rows * 16);
static_assert(offsetof(PlacedBody, started) == 28 && offsetof(PlacedBody, options) == 32);
static_assert(offsetof(FootPlacementOptions, lock) == 28 && offsetof(PlacedBody, drop) == 72);
static_assert(std::is_trivially_copyable_v<PlacedBody>);

/// The state of one foot, in rows of four floats.
///
///      0        24        28          32     96      108       112
///     [ ground | planted | missed_by | lock | ankle | reached ]
struct alignas(16) PlacedFoot {
  // The owner sets these two.
  Footing ground{};                 ///< the plane to stand on, world space; too steep or broken, it counts as flat
  float planted = planted_by_pose;  ///< 0 (in the air) to 1 (on the ground), or planted_by_pose
  // These are results of the last update.
  float missed_by = 0.0F;  ///< metres that the ankle is from where it should be
  FootLock lock{};
  glm::vec3 ankle{0.0F};  ///< model space, before it was placed: where to look for the ground
  float reached = 1.0F;  ///< the share of the way from its pose to its lock that the leg reaches; below 1: it gives way
};
static_assert(sizeof(PlacedFoot) == 112 && offsetof(PlacedFoot, missed_by) == 28 && offsetof(PlacedFoot, lock) == 32);
static_assert(offsetof(PlacedFoot, ankle) == 96 && offsetof(PlacedFoot, reached) == 108);
static_assert(std::is_trivially_copyable_v<PlacedFoot>);

/// Puts feet on uneven ground. The pose is made for flat ground at height 0 and moves to the ground given. Feet keep
/// their height above it and tilt with it. Planted feet touch it with the lowest point of the sole and stay where they
/// came down, as far as their legs reach. The pelvis is lowered as the ground asks: a place that a foot is locked at
/// lowers it by no more than lock_reserve. Levels of detail without all legs are left alone.
struct FootPlacementJob {
  const FootPlacementRig* rig = nullptr;
  PlacedBody* body = nullptr;
  PlacedFoot* feet = nullptr;  ///< [rig->leg_count]
  PoseView pose;               ///< it may displace rig->pelvis_bone()
  float seconds = 0.0F;        ///< since the last frame, not negative
  float weight = 1.0F;         ///< 0 leaves the pose to the bit and forgets all state except the ankles
};
bool is_valid(const FootPlacementJob& job);
/// Returns whether all jobs are valid and of one rig.
bool is_valid(std::span<const FootPlacementJob> jobs);

inline bool has_all_legs(const FootPlacementRig& rig, const PoseView& pose) { return rig.bone_end <= pose.bone_count; }

/// Clears the state of earlier updates; members that the owner sets stay.
void forget_feet(const FootPlacementJob& job);

}  // namespace throng::anim
