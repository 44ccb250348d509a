// The kernel of foot_placement.h, one character a lane.
#if defined(THRONG_KERNEL_FOOT_PLACEMENT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_FOOT_PLACEMENT_INL_H
#undef THRONG_KERNEL_FOOT_PLACEMENT_INL_H
#else
#define THRONG_KERNEL_FOOT_PLACEMENT_INL_H
#endif

#include <cassert>

#include "engine/anim/kernel/lanes/smooth_damp-inl.h"
#include "engine/anim/kernel/limb/foot_goals-inl.h"
#include "engine/anim/kernel/limb/two_bone_ik-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// Smooths the drop, in time for a foot that lands. A new character has its drop at once.
template <class D, class V>
HWY_INLINE DampedValues<V> next_drop(D d, const PlacedBodies<D>& bodies, V wanted) {
  DampedValues<V> next = damped(d, bodies.drop, wanted, bodies.drop_smooth_seconds, bodies.seconds);
  const V fastest = hn::MulAdd(bodies.fastest_drop, bodies.seconds, bodies.drop.value);
  next.value = hn::Max(next.value, hn::Min(hn::Sub(wanted, bodies.most_gap), fastest));
  return {hn::IfThenElse(bodies.started, next.value, wanted), hn::IfThenElseZero(bodies.started, next.velocity)};
}

template <class D>
class FootPlacer {
 public:
  using V = hn::Vec<D>;

  /// Places the feet of at least one job. Lanes beyond the last job repeat it.
  void place(const FootPlacementRig& rig, std::span<const FootPlacementJob* const> jobs) {
    const D d;
    for (int lane = 0; lane < lane_count<D>; ++lane) {
      jobs_[lane] = jobs[HWY_MIN(static_cast<std::size_t>(lane), jobs.size() - 1)];
    }
    bodies_.load(d, jobs_);
    pose_legs(d, rig);
    V wanted = hn::Zero(d);
    for (int leg = 0; leg < rig.leg_count; ++leg) {
      const PlacedLeg& about = rig.legs.data()[leg];
      feet_[leg].load(d, jobs_, leg);
      feet_[leg].ankle = ankle_of(rig, leg).position;
      const LegReaches<V> reach = reach_of(d, legs_[leg].motions[about.limb.upper].position,
                                           legs_[leg].motions[about.limb.middle].position, ankle_of(rig, leg).position);
      goals_[leg] = goal_of(d, about, bodies_, reach, ankle_of(rig, leg), feet_[leg]);
      wanted = hn::Max(wanted, hn::Mul(goals_[leg].planted, goals_[leg].drop));
    }
    bodies_.drop = next_drop(d, bodies_, hn::Min(wanted, bodies_.max_drop));
    lower_pelvis(d, rig);
    for (int leg = 0; leg < rig.leg_count; ++leg) solve_leg(d, rig, leg);
    pose_.store();
    bodies_.store(d, jobs_);
  }

 private:
  JointMotions<V>& ankle_of(const FootPlacementRig& rig, int leg) {
    return legs_[leg].motions[rig.legs.data()[leg].limb.end()];
  }

  /// All legs share one chain down to the pelvis.
  void pose_legs(D d, const FootPlacementRig& rig) {
    const PoseView* poses[lane_count<D>];
    for (int lane = 0; lane < lane_count<D>; ++lane) poses[lane] = &jobs_[lane]->pose;
    pose_.begin(poses);
    for (int leg = 0; leg < rig.leg_count; ++leg) {
      const JointChain& chain = rig.legs.data()[leg].limb.chain;
      legs_[leg].find(chain, pose_);
      if (leg > 0) legs_[leg].motions[rig.pelvis] = legs_[0].motions[rig.pelvis];
      legs_[leg].pose_from(d, leg == 0 ? 0 : rig.pelvis + 1, chain, pose_);
    }
  }

  void lower_pelvis(D d, const FootPlacementRig& rig) {
    const V drop = hn::Max(hn::Mul(bodies_.drop.value, bodies_.weight), hn::Zero(d));
    const Quaternions<V> parent = rig.pelvis == 0 ? no_rotation(d) : legs_[0].motions[rig.pelvis - 1].rotation;
    const Vectors<V> shift = upwards(d, hn::Neg(drop));
    const BonePlace pelvis = legs_[0].bones[rig.pelvis];
    const Vectors<V> posed = pose_.position(d, pelvis);
    const Vectors<V> lowered = sum(posed, rotated(conjugate(parent), shift));
    pose_.move(d, pelvis, choose(hn::Gt(drop, hn::Zero(d)), lowered, posed));
    for (int leg = 0; leg < rig.leg_count; ++leg) {
      for (int joint = rig.pelvis; joint < rig.legs.data()[leg].limb.chain.count; ++joint) {
        Vectors<V>& position = legs_[leg].motions[joint].position;
        position = sum(position, shift);
      }
    }
  }

  void solve_leg(D d, const FootPlacementRig& rig, int leg) {
    const PlacedLeg& about = rig.legs.data()[leg];
    const FootGoals<V>& goal = goals_[leg];
    PlacedFeet<D>& foot = feet_[leg];
    const V zero = hn::Zero(d);
    const LimbGoals<D> limb_goals{.target = goal.ankle.position,
                                  .pole = {zero, zero, zero},
                                  .weight = bodies_.weight,
                                  .softness = hn::Set(d, default_limb_softness),
                                  .end_rotation = goal.ankle.rotation,
                                  .turns_end = hn::Ge(zero, zero)};
    foot.missed_by = solve_two_bone_ik(d, about.limb, limb_goals, pose_, legs_[leg]);
    const JointMotions<V>& ankle = ankle_of(rig, leg);
    const Vectors<V> ball = sum(ankle.position, rotated(ankle.rotation, broadcast_vector(d, &about.sole[1].x)));
    const V standing = hn::IfThenZeroElse(hn::Gt(goal.steps, zero), goal.planted);
    measure_slide(d, foot.lock, to_world(bodies_.model_in_world, ball), standing, bodies_.seconds);
    foot.store(d, jobs_, leg);
  }

  const FootPlacementJob* jobs_[lane_count<D>];
  PlacedBodies<D> bodies_;
  PlacedFeet<D> feet_[max_legs];
  FootGoals<V> goals_[max_legs];
  ChainLanes<D> legs_[max_legs];
  PoseLanes<D, most_leg_quads> pose_;
};

inline void place_feet(std::span<const FootPlacementJob> jobs) {
  assert(is_valid(jobs));
  using D = BoneLanes;
  const FootPlacementJob* some[lane_count<D>];
  FootPlacer<D> placer;
  std::size_t count = 0;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (!has_all_legs(*jobs[i].rig, jobs[i].pose)) {
      forget_feet(jobs[i]);
    } else {
      some[count++] = &jobs[i];
    }
    if (count == 0 || (count < std::size_t{lane_count<D>} && i + 1 < jobs.size())) continue;
    placer.place(*some[0]->rig, {some, count});
    for (const FootPlacementJob* job : std::span(some, count)) {
      if (job->weight <= 0.0F) forget_feet(*job);
    }
    count = 0;
  }
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
