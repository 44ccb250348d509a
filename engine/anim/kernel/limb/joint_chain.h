#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "engine/anim/asset/skeleton.h"
#include "engine/anim/kernel/pose/pose_view.h"
#include "engine/base/result.h"

namespace throng::anim {

/// The joints from a root bone down to a tip, which are enough to pose the tip without any other bone. They are made at
/// load and shared by every character of the skeleton.
struct JointChain {
  static constexpr int max_joints = 24;
  int count = 0;                                 ///< 1 to max_joints once made
  std::array<std::int16_t, max_joints> bones{};  ///< root first, tip last, ascending
  std::array<glm::vec3, max_joints> offsets{};   ///< metres, bind pose: from the joint before; the root has its origin

  int tip() const { return count - 1; }
  /// Returns one above the chain's highest bone.
  int bone_end() const { return bones.data()[tip()] + 1; }
  /// Returns the index of a bone in the chain, or -1.
  int find(int bone) const;
};
static_assert(std::is_trivially_copyable_v<JointChain>);

/// Returns one above the highest bone of several limbs, each with a `chain`; 0 if there are none.
template <typename Limbs>
int bone_end_of(const Limbs& limbs) {
  int end = 0;
  for (const auto& limb : limbs) end = std::max(end, limb.chain.bone_end());
  return end;
}

/// A posed joint in model space.
struct JointMotion {
  glm::quat rotation{1.0F, 0.0F, 0.0F, 0.0F};  ///< from the bind pose, unit
  glm::vec3 position{0.0F};                    ///< metres
};
static_assert(std::is_trivially_copyable_v<JointMotion>);

/// Returns whether the rotation is unit, and a joint can have the place (is_place).
bool is_valid(const JointMotion& motion);

/// Makes a product of nearly unit quaternions unit by one Newton step. A square root and a division would delay the
/// next joint.
inline glm::quat renormalised(const glm::quat& product) { return product * (1.5F - 0.5F * glm::dot(product, product)); }

/// Memory for the motions of a chain. It is not initialised, because that takes as long as posing.
class ChainMotion {
 public:
  JointMotion& operator[](std::size_t joint) { return all()[joint]; }
  const JointMotion& operator[](std::size_t joint) const { return all()[joint]; }
  operator std::span<JointMotion>() { return {all(), JointChain::max_joints}; }
  operator std::span<const JointMotion>() const { return {all(), JointChain::max_joints}; }

 private:
  JointMotion* all() { return reinterpret_cast<JointMotion*>(room_); }
  const JointMotion* all() const { return reinterpret_cast<const JointMotion*>(room_); }

  alignas(JointMotion) std::byte room_[JointChain::max_joints * sizeof(JointMotion)];
};

/// Returns the chain that ends at `bone`. Errors: a bone that the skeleton lacks, more than max_joints, and skeletons
/// on the general path, because rotations alone do not describe their scales and sheared prefixes.
Result<JointChain> make_joint_chain(const Skeleton& skeleton, int bone);

/// Returns whether the pose has all bones of the chain. Levels of detail drop the ends of limbs.
inline bool is_within(const JointChain& chain, const PoseView& pose) { return chain.bone_end() <= pose.bone_count; }

/// Poses the joints from `first` on; joints before it keep their motion. `motions` has at least chain.count
/// elements. The pose's rotations are unit to a thousandth.
/// M are rotations from the bind pose, X positions, q' and d the state (ReferenceFrame), and p is the parent:
///     M = M_p * q',   X = X_p + M_p * (offset + d)
void pose_chain(const JointChain& chain, const PoseView& pose, std::span<JointMotion> motions, int first = 0);

}  // namespace throng::anim
