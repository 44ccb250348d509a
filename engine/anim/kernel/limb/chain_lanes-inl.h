// Poses joint chains (joint_chain.h), one character a lane.
#if defined(THRONG_KERNEL_CHAIN_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_CHAIN_LANES_INL_H
#undef THRONG_KERNEL_CHAIN_LANES_INL_H
#else
#define THRONG_KERNEL_CHAIN_LANES_INL_H
#endif

#include "engine/anim/kernel/lanes/angles-inl.h"
#include "engine/anim/kernel/limb/joint_chain.h"
#include "engine/anim/kernel/pose/pose_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// JointMotion, joint_chain.h.
template <class V>
struct JointMotions {
  Quaternions<V> rotation;
  Vectors<V> position;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE JointMotions<V> no_motion(D d) {
  return {no_rotation(d), {hn::Zero(d), hn::Zero(d), hn::Zero(d)}};
}

/// Returns the motion of a joint below `parent`, rotated and displaced by the state of its bone.
template <class D, class V>
HWY_INLINE JointMotions<V> posed_joint(D d, const JointMotions<V>& parent, const glm::vec3& offset,
                                       const Quaternions<V>& rotation, const Vectors<V>& position) {
  const Vectors<V> from_parent = sum(broadcast_vector(d, &offset.x), position);
  return {renormalised(d, product(parent.rotation, rotation)),
          sum(parent.position, rotated(parent.rotation, from_parent))};
}

/// The joints of a chain: their bones among the bones that were read, and their motions, model space.
template <class D>
struct ChainLanes {
  BonePlace bones[JointChain::max_joints];
  JointMotions<hn::Vec<D>> motions[JointChain::max_joints];

  template <class Pose>
  void find(const JointChain& chain, Pose& pose) {
    for (int joint = 0; joint < chain.count; ++joint) bones[joint] = pose.place_of(chain.bones.data()[joint]);
  }
  /// Poses the joints from `first` on; joints before it are posed already.
  template <class Pose>
  HWY_INLINE void pose_from(D d, int first, const JointChain& chain, const Pose& pose) {
    JointMotions<hn::Vec<D>> motion = first == 0 ? no_motion(d) : motions[first - 1];
    for (int joint = first; joint < chain.count; ++joint) {
      motion = posed_joint(d, motion, chain.offsets.data()[joint], pose.rotation(d, bones[joint]),
                           pose.position(d, bones[joint]));
      motions[joint] = motion;
    }
  }
};

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
