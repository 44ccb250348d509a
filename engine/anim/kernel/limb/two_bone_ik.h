#pragma once

#include <span>
#include <type_traits>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "engine/anim/kernel/limb/joint_chain.h"
#include "engine/anim/kernel/pose/pose_view.h"
#include "engine/base/result.h"

namespace throng::anim {

/// A limb that bends at one joint: hip, knee, ankle, or shoulder, elbow, wrist. Joints between them (twist bones,
/// halves of a thigh) follow the joint above. It is made at load and shared by every character of the skeleton.
struct TwoBoneLimb {
  JointChain chain;  ///< its tip is the end of the limb
  int upper = 0;     ///< index into the chain, like `middle`
  int middle = 0;
  glm::vec3 hinge{1.0F, 0.0F, 0.0F};  ///< axis about which the middle bends, bind pose, unit

  int end() const { return chain.tip(); }
};
static_assert(std::is_trivially_copyable_v<TwoBoneLimb>);

/// The length in metres below which a bone is too short: its limb is not solved.
inline constexpr float shortest_limb_bone = 1e-6F;

/// Makes a limb. `bend_direction` (model space) says where the middle points when it bends, for limbs that are straight
/// in the bind pose: +Z for knees, -Z for elbows. Errors: those of make_joint_chain; `middle` is not below `upper`,
/// `end` is not below `middle`, or two of them are at one position.
Result<TwoBoneLimb> make_two_bone_limb(const Skeleton& skeleton, int upper, int middle, int end,
                                       const glm::vec3& bend_direction);

/// The sines of the angle at the middle joint below which the hinge alone says how a limb bends, and above which the
/// pose does.
inline constexpr float straight_below = 0.02F;
inline constexpr float bent_above = 0.1F;

/// Returns the axis about which a limb bends. `first` and `second` are the unit directions of its bones. Where it is
/// nearly straight, its hinge decides.
glm::vec3 bend_normal(const glm::vec3& first, const glm::vec3& second, const glm::vec3& hinge);

/// Softness, as a fraction of the limb's length.
inline constexpr float default_limb_softness = 0.005F;
inline constexpr float most_limb_softness = 0.5F;

/// Two-bone IK (paper 2.2.1 names IK among an animation system's tasks). It turns the upper and the middle joint so
/// that the end is at `target`. A limb reaches for a target out of reach.
///
/// The pose stays as it is where this level of detail lacks the limb, where the limb has no length, and where the
/// target is not finite (see is_place). A limb that is straighter than softness allows stays so if its end is at the
/// target.
struct TwoBoneIkJob {
  const TwoBoneLimb* limb = nullptr;
  PoseView pose;
  glm::vec3 target{0.0F};                          ///< model space, metres
  glm::vec3 pole{0.0F};                            ///< model space: where the middle must point; zero keeps the pose's
  float weight = 1.0F;                             ///< 0 leaves the pose to the bit, 1 reaches
  float softness = default_limb_softness;          ///< 0 to 0.5: this last fraction of the length is never quite used
                                                   ///< up, so that the middle does not snap straight
  bool turn_end = false;                           ///< also give the end joint `end_rotation`
  glm::quat end_rotation{1.0F, 0.0F, 0.0F, 0.0F};  ///< model space, from the bind pose, unit
};
bool is_valid(const TwoBoneIkJob& job);
/// Returns whether all jobs are valid and of one limb.
bool is_valid(std::span<const TwoBoneIkJob> jobs);

}  // namespace throng::anim
