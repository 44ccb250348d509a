// The kernel of two_bone_ik.h, one character a lane.
#if defined(THRONG_KERNEL_TWO_BONE_IK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_TWO_BONE_IK_INL_H
#undef THRONG_KERNEL_TWO_BONE_IK_INL_H
#else
#define THRONG_KERNEL_TWO_BONE_IK_INL_H
#endif

#include <cassert>

#include "engine/anim/kernel/limb/chain_lanes-inl.h"
#include "engine/anim/kernel/limb/limb_angles-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// Rotates the joints from the upper one on. Lanes that are not `active` keep their bits.
template <class D, class Pose, class V = hn::Vec<D>>
HWY_INLINE void turn_limb(D d, const TwoBoneLimb& limb, const LimbGoals<D>& goals, const LimbTurns<V>& turns,
                          hn::Mask<D> active, Pose& pose, ChainLanes<D>& chain) {
  const auto whole = hn::Ge(goals.weight, hn::Set(d, 1.0F));
  const auto end_stays = hn::Not(goals.turns_end);
  JointMotions<V> motion = limb.upper == 0 ? no_motion(d) : chain.motions[limb.upper - 1];
  Quaternions<V> solved_parent = motion.rotation;
  for (int joint = limb.upper; joint < limb.chain.count; ++joint) {
    const Quaternions<V> before = pose.rotation(d, chain.bones[joint]);
    const Quaternions<V>& posed = chain.motions[joint].rotation;
    Quaternions<V> after = before;
    const Quaternions<V> followed = product(solved_parent, before);
    Quaternions<V> solved = followed;
    if (joint == limb.upper) solved = product(turns.upper, posed);
    if (joint == limb.middle) solved = product(turns.middle, posed);
    if (joint == limb.end()) solved = choose(end_stays, followed, goals.end_rotation);
    if (joint == limb.upper || joint == limb.middle || joint == limb.end()) {
      after = unit(d, product(conjugate(solved_parent), solved));
      if (!hn::AllTrue(d, whole)) after = choose(whole, after, mix_rotations(d, before, after, goals.weight));
      after = choose(joint == limb.end() ? hn::And(active, goals.turns_end) : active, after, before);
      pose.turn(d, chain.bones[joint], after);
    }
    solved_parent = renormalised(d, solved);
    motion = posed_joint(d, motion, limb.chain.offsets.data()[joint], after, pose.position(d, chain.bones[joint]));
    chain.motions[joint] = motion;
  }
}

/// Bends limbs whose chains are posed; the chains follow. Returns the distances of the ends from the targets, metres.
template <class D, class Pose, class V = hn::Vec<D>>
HWY_INLINE V solve_two_bone_ik(D d, const TwoBoneLimb& limb, const LimbGoals<D>& goals, Pose& pose,
                               ChainLanes<D>& chain) {
  const LimbPlaces<V> places{chain.motions[limb.upper].position, chain.motions[limb.middle].position,
                             chain.motions[limb.end()].position};
  const V shortest = hn::Set(d, shortest_limb_bone);
  const auto has_length = hn::And(hn::Gt(length_of(difference(places.middle, places.upper)), shortest),
                                  hn::Gt(length_of(difference(places.end, places.middle)), shortest));
  const auto is_to_move = hn::And(has_length, hn::Gt(goals.weight, hn::Zero(d)));
  const auto has_target = are_places(d, goals.target);
  const Vectors<V> hinge = rotated(chain.motions[limb.upper].rotation, broadcast_vector(d, &limb.hinge.x));
  turn_limb(d, limb, goals, solve_limb(d, goals, places, hinge), hn::And(is_to_move, has_target), pose, chain);
  const V missed_by = length_of(difference(chain.motions[limb.end()].position, goals.target));
  return hn::IfThenElseZero(has_target, missed_by);
}

template <class D>
class LimbLanes {
 public:
  using V = hn::Vec<D>;

  /// Solves at least one job of one limb. Lanes beyond the last job repeat it.
  void solve(std::span<const TwoBoneIkJob* const> jobs, float* const* missed_by) {
    const D d;
    const TwoBoneLimb& limb = *jobs.front()->limb;
    const PoseView* poses[lane_count<D>];
    for (int lane = 0; lane < lane_count<D>; ++lane) {
      const TwoBoneIkJob& job = *jobs[HWY_MIN(static_cast<std::size_t>(lane), jobs.size() - 1)];
      poses[lane] = &job.pose;
      load_goals(lane, job);
    }
    pose_.begin(poses);
    chain_.find(limb.chain, pose_);
    chain_.pose_from(d, 0, limb.chain, pose_);
    const V missed = solve_two_bone_ik(d, limb, goals(d), pose_, chain_);
    pose_.store();
    missed_.store(d, missed);
    for (std::size_t lane = 0; lane < jobs.size(); ++lane) *missed_by[lane] = missed_.of[lane];
  }

 private:
  void load_goals(int lane, const TwoBoneIkJob& job) {
    for (int axis = 0; axis < 3; ++axis) {
      target_[axis].of[lane] = job.target[axis];
      pole_[axis].of[lane] = job.pole[axis];
    }
    for (int part = 0; part < 4; ++part) end_rotation_[part].of[lane] = job.end_rotation[part];
    weight_.of[lane] = job.weight;
    softness_.of[lane] = job.softness;
    turns_end_.of[lane] = job.turn_end ? 1.0F : 0.0F;
  }
  LimbGoals<D> goals(D d) const {
    return {.target = {target_[0].load(d), target_[1].load(d), target_[2].load(d)},
            .pole = {pole_[0].load(d), pole_[1].load(d), pole_[2].load(d)},
            .weight = weight_.load(d),
            .softness = softness_.load(d),
            .end_rotation = {end_rotation_[0].load(d), end_rotation_[1].load(d), end_rotation_[2].load(d),
                             end_rotation_[3].load(d)},
            .turns_end = hn::Gt(turns_end_.load(d), hn::Zero(d))};
  }

  Lane<D> target_[3], pole_[3], end_rotation_[4], weight_, softness_, turns_end_, missed_;
  PoseLanes<D, JointChain::max_joints> pose_;
  ChainLanes<D> chain_;
};

inline void two_bone_ik(std::span<const TwoBoneIkJob> jobs, float* missed_by) {
  assert(is_valid(jobs));
  using D = BoneLanes;
  const TwoBoneIkJob* some[lane_count<D>];
  float* missed[lane_count<D>];
  LimbLanes<D> limbs;
  std::size_t count = 0;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    missed_by[i] = 0.0F;
    if (!is_within(jobs[i].limb->chain, jobs[i].pose)) continue;
    missed[count] = &missed_by[i];
    some[count++] = &jobs[i];
    if (count < std::size_t{lane_count<D>}) continue;
    limbs.solve({some, count}, missed);
    count = 0;
  }
  if (count > 0) limbs.solve({some, count}, missed);
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
