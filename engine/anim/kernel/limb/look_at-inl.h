// The kernel of look_at.h, one character a lane. From the first looking joint on everything is relative to its parent:
// there forward, up and left are constants, and rotations about them are short.
#if defined(THRONG_KERNEL_LOOK_AT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_LOOK_AT_INL_H
#undef THRONG_KERNEL_LOOK_AT_INL_H
#else
#define THRONG_KERNEL_LOOK_AT_INL_H
#endif

#include <cassert>

#include "engine/anim/kernel/lanes/rotations.h"
#include "engine/anim/kernel/lanes/smooth_damp-inl.h"
#include "engine/anim/kernel/limb/chain_lanes-inl.h"
#include "engine/anim/kernel/limb/look_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// Radians of yaw from which a target may be looked at over either shoulder.
inline constexpr float behind = 2.6F;
/// Metres from the eyes, squared.
inline constexpr float nearest_target_square = 1e-8F;

/// The looking joints and those between them, by index in the chain, relative to their parent.
template <class V>
struct LookingChain {
  Quaternions<V> rotations[JointChain::max_joints];
  JointMotions<V> head;
};

/// The parent of the first looking joint, in model space.
template <class D, class V = hn::Vec<D>>
HWY_INLINE JointMotions<V> pose_carrier(D d, const LookAtRig& rig, const LookLanes<D>& lanes) {
  JointMotions<V> carrier{no_rotation(d), {hn::Zero(d), hn::Zero(d), hn::Zero(d)}};
  for (int joint = 0; joint < rig.joints.front(); ++joint) {
    carrier.position = sum(carrier.position, rotated(carrier.rotation, lanes.offset(d, rig.chain, joint)));
    carrier.rotation = product(carrier.rotation, lanes.rotation(d, joint));
  }
  carrier.rotation = renormalised(d, carrier.rotation);
  return carrier;
}

template <class D, class V>
HWY_INLINE void pose_looking_joints(D d, const LookAtRig& rig, const LookLanes<D>& lanes, LookingChain<V>& posed) {
  posed.head.rotation = no_rotation(d);
  for (int joint = rig.joints.front(); joint < rig.chain.count; ++joint) {
    posed.head.rotation = product(posed.head.rotation, lanes.rotation(d, joint));
    posed.rotations[joint] = posed.head.rotation;
  }
}

template <class D, class V>
HWY_INLINE Gazes<V> gaze_along(D d, const LookAtRig& rig, const Vectors<V>& direction) {
  const V forward_x = hn::Set(d, rig.forward.x);
  const V forward_z = hn::Set(d, rig.forward.z);
  const V ahead = hn::MulAdd(direction.z, forward_z, hn::Mul(direction.x, forward_x));
  const V aside = hn::NegMulAdd(direction.z, forward_x, hn::Mul(direction.x, forward_z));
  const V level = hn::Sqrt(hn::MulAdd(aside, aside, hn::Mul(ahead, ahead)));
  return {angle_of(d, aside, ahead), angle_of(d, direction.y, level)};
}

/// Turns from one direction of look by `share` towards another: `back` to the front, up or down, and round again. It
/// keeps the roll of the head and never turns through the back.
template <class D, class V>
HWY_INLINE Quaternions<V> turn_between(D d, const LookAtRig& rig, const Gazes<V>& from, const Gazes<V>& to,
                                       const HalfAngle<V>& back, V share) {
  const HalfAngle<V> round = half_angle(d, hn::MulAdd(hn::Sub(to.yaw, from.yaw), share, from.yaw));
  const HalfAngle<V> up = half_angle(d, hn::Mul(hn::Sub(to.pitch, from.pitch), share));
  // About (-forward.z, 0, forward.x), then about (0, 1, 0).
  const V across_x = hn::Mul(up.sine, hn::Set(d, -rig.forward.z));
  const V across_z = hn::Mul(up.sine, hn::Set(d, rig.forward.x));
  const Quaternions<V> ahead{
      hn::MulAdd(round.sine, across_z, hn::Mul(round.cosine, across_x)), hn::Mul(round.sine, up.cosine),
      hn::NegMulAdd(round.sine, across_x, hn::Mul(round.cosine, across_z)), hn::Mul(round.cosine, up.cosine)};
  return {hn::MulAdd(ahead.z, back.sine, hn::Mul(ahead.x, back.cosine)),
          hn::NegMulAdd(ahead.w, back.sine, hn::Mul(ahead.y, back.cosine)),
          hn::NegMulAdd(ahead.x, back.sine, hn::Mul(ahead.z, back.cosine)),
          hn::MulAdd(ahead.y, back.sine, hn::Mul(ahead.w, back.cosine))};
}

/// Returns the chain with every looking joint rotated by its share.
template <class D, class V>
HWY_INLINE void turn_chain(D d, const LookAtRig& rig, const LookLanes<D>& lanes, const Gazes<V>& from,
                           const Gazes<V>& to, const LookingChain<V>& posed, LookingChain<V>& turned) {
  const HalfAngle<V> back = half_angle(d, from.yaw);
  const V weight = lanes.weight.load(d);
  Quaternions<V> turn = no_rotation(d);
  turned.head = {turn, {hn::Zero(d), hn::Zero(d), hn::Zero(d)}};
  for (int joint = rig.joints.front(), next = 0; joint < rig.chain.count; ++joint) {
    turned.head.position = sum(turned.head.position, rotated(turned.head.rotation, lanes.offset(d, rig.chain, joint)));
    if (joint == rig.joints.data()[next]) {
      turn = turn_between(d, rig, from, to, back, hn::Mul(hn::Set(d, rig.turned.data()[next]), weight));
      ++next;
    }
    turned.head.rotation = product(turn, posed.rotations[joint]);
    turned.rotations[joint] = turned.head.rotation;
  }
}

template <class D, class V>
HWY_INLINE Vectors<V> eyes_of(D d, const LookAtRig& rig, const JointMotions<V>& head) {
  return sum(head.position, rotated(head.rotation, broadcast_vector(d, &rig.eyes.x)));
}

/// Returns the direction from the eyes to the target, within the limits.
template <class D, class V>
HWY_INLINE Gazes<V> wanted_gaze(D d, const LookAtRig& rig, const LookLanes<D>& lanes, const Gazes<V>& last,
                                const Vectors<V>& to_target) {
  Gazes<V> gaze = gaze_along(d, rig, to_target);
  const auto other_shoulder =
      hn::And(hn::Gt(hn::Abs(gaze.yaw), hn::Set(d, behind)), hn::Lt(hn::Mul(gaze.yaw, last.yaw), hn::Zero(d)));
  gaze.yaw = hn::IfThenElse(other_shoulder, hn::Neg(gaze.yaw), gaze.yaw);
  const auto between = [](V value, V least, V most) { return hn::Min(hn::Max(value, least), most); };
  const V most_yaw = lanes.most_yaw.load(d);
  gaze = {between(gaze.yaw, hn::Neg(most_yaw), most_yaw),
          between(gaze.pitch, hn::Neg(lanes.most_down.load(d)), lanes.most_up.load(d))};
  const auto too_near = hn::Lt(dot(to_target, to_target), hn::Set(d, nearest_target_square));
  return {hn::IfThenElse(too_near, last.yaw, gaze.yaw), hn::IfThenElse(too_near, last.pitch, gaze.pitch)};
}

/// Brings the direction of look of each character one step nearer to the one it wants.
template <class D, class V>
HWY_INLINE Gazes<V> follow(D d, LookLanes<D>& lanes, const Gazes<V>& last, const Gazes<V>& wanted) {
  const auto started = hn::Gt(lanes.started.load(d), hn::Zero(d));
  const V smooth_seconds = lanes.smooth_seconds.load(d);
  const V seconds = lanes.seconds.load(d);
  const auto step = [&](V value, Lane<D>& velocity, V target, Lane<D>& to) {
    const V moving = hn::IfThenElseZero(started, velocity.load(d));
    const DampedValues<V> next = damped(d, DampedValues<V>{value, moving}, target, smooth_seconds, seconds);
    to.store(d, next.value);
    velocity.store(d, next.velocity);
    return next.value;
  };
  return {step(last.yaw, lanes.yaw_velocity, wanted.yaw, lanes.yaw),
          step(last.pitch, lanes.pitch_velocity, wanted.pitch, lanes.pitch)};
}

template <class D, class V>
HWY_INLINE void store_rotations(D d, const LookAtRig& rig, const LookingChain<V>& turned, LookLanes<D>& lanes) {
  for (int i = 0; i < rig.joint_count; ++i) {
    const int joint = rig.joints.data()[i];
    const Quaternions<V> parent = joint == rig.joints.front() ? no_rotation(d) : turned.rotations[joint - 1];
    lanes.turn(d, joint, renormalised(d, product(conjugate(parent), turned.rotations[joint])));
  }
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE void look_at_lanes(D d, const LookAtRig& rig, LookLanes<D>& lanes) {
  const Vectors<V> forward = broadcast_vector(d, &rig.forward.x);
  const JointMotions<V> carrier = pose_carrier(d, rig, lanes);
  const Vectors<V> place{hn::Sub(lanes.target[0].load(d), carrier.position.x),
                         hn::Sub(lanes.target[1].load(d), carrier.position.y),
                         hn::Sub(lanes.target[2].load(d), carrier.position.z)};
  const Vectors<V> target = rotated(conjugate(carrier.rotation), place);
  LookingChain<V> posed;
  pose_looking_joints(d, rig, lanes, posed);
  const Gazes<V> from = gaze_along(d, rig, rotated(posed.head.rotation, forward));
  const auto started = hn::Gt(lanes.started.load(d), hn::Zero(d));
  const Gazes<V> last{hn::IfThenElse(started, lanes.yaw.load(d), from.yaw),
                      hn::IfThenElse(started, lanes.pitch.load(d), from.pitch)};

  // The eyes move with the head. Measured from their last position, the look settles on the target exactly.
  LookingChain<V> turned;
  Vectors<V> eyes{lanes.eyes[0].load(d), lanes.eyes[1].load(d), lanes.eyes[2].load(d)};
  if (!hn::AllTrue(d, started)) {
    turn_chain(d, rig, lanes, from, from, posed, turned);
    const Vectors<V> posed_eyes = eyes_of(d, rig, turned.head);
    eyes = {hn::IfThenElse(started, eyes.x, posed_eyes.x), hn::IfThenElse(started, eyes.y, posed_eyes.y),
            hn::IfThenElse(started, eyes.z, posed_eyes.z)};
  }
  const Gazes<V> wanted = wanted_gaze(d, rig, lanes, last, difference(target, eyes));
  turn_chain(d, rig, lanes, from, follow(d, lanes, last, wanted), posed, turned);
  store_rotations(d, rig, turned, lanes);
  eyes = eyes_of(d, rig, turned.head);
  lanes.eyes[0].store(d, eyes.x);
  lanes.eyes[1].store(d, eyes.y);
  lanes.eyes[2].store(d, eyes.z);
  const Vectors<V> facing = rotated(turned.head.rotation, forward);
  const Vectors<V> to_target = difference(target, eyes);
  const Vectors<V> across = cross(facing, to_target);
  lanes.remaining.store(d, angle_of(d, hn::Sqrt(dot(across, across)), dot(facing, to_target)));
}

/// Collects the jobs that turn a head. The others are finished here.
HWY_INLINE std::size_t lookers_of(std::span<const LookAtJob> jobs, const LookAtJob** lookers) {
  std::size_t count = 0;
  for (const LookAtJob& job : jobs) {
    job.state->remaining = 0.0F;
    if (job.weight <= 0.0F) *job.state = {};
    if (job.weight > 0.0F && is_within(job.rig->chain, job.pose) && is_place(job.target)) lookers[count++] = &job;
  }
  return count;
}

inline void look_at(std::span<const LookAtJob> jobs) {
  assert(is_valid(jobs));
  using D = BoneLanes;
  const LookAtJob* all[widest_strip];
  const std::span<const LookAtJob* const> lookers(all, lookers_of(jobs, all));
  LookLanes<D> lanes;
  for (std::size_t first = 0; first < lookers.size(); first += std::size_t{lane_count<D>}) {
    const auto some = lookers.subspan(first, HWY_MIN(std::size_t{lane_count<D>}, lookers.size() - first));
    const LookAtRig& rig = *some.front()->rig;
    lanes.load(rig, some);
    look_at_lanes(D(), rig, lanes);
    lanes.store();
  }
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
