// Computes where feet go on the ground (foot_placement.h), one character a lane.
#if defined(THRONG_KERNEL_FOOT_GOALS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_FOOT_GOALS_INL_H
#undef THRONG_KERNEL_FOOT_GOALS_INL_H
#else
#define THRONG_KERNEL_FOOT_GOALS_INL_H
#endif

#include "engine/anim/kernel/limb/foot_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// The least y of a normal. Steeper ground counts as flat, and so does ground that is not finite.
inline constexpr float steepest_ground = 0.2F;

/// The two ends of the sole, relative to the ankle and rotated with the foot.
template <class V>
struct Soles {
  Vectors<V> heel, ball;
};

template <class D, class V>
HWY_INLINE Soles<V> sole_of(D d, const PlacedLeg& leg, const Quaternions<V>& foot) {
  return {rotated(foot, broadcast_vector(d, &leg.sole[0].x)), rotated(foot, broadcast_vector(d, &leg.sole[1].x))};
}

/// Returns the distance from the ankle to the lowest point of the sole, along `normal`.
template <class V>
HWY_INLINE V clearance(const Soles<V>& sole, const Vectors<V>& normal) {
  return hn::Neg(hn::Min(dot(sole.heel, normal), dot(sole.ball, normal)));
}

/// Returns the shortest rotation from straight up to `normal`, limited to the angle of this cosine.
template <class D, class V>
HWY_INLINE Quaternions<V> limited_tilt(D d, const Vectors<V>& normal, V least_cosine) {
  const V one = hn::Set(d, 1.0F);
  const V half = hn::Set(d, 0.5F);
  const auto limited = hn::Lt(normal.y, least_cosine);
  const V level = hn::Sqrt(hn::MulAdd(normal.z, normal.z, hn::Mul(normal.x, normal.x)));
  const V half_sine = hn::Sqrt(hn::Max(hn::NegMulAdd(least_cosine, half, half), hn::Zero(d)));
  const V half_cosine = hn::Sqrt(hn::MulAdd(least_cosine, half, half));
  const V aside = hn::IfThenElse(limited, hn::Div(half_sine, hn::Max(level, hn::Set(d, 1e-12F))), one);
  const V along = hn::IfThenElse(limited, half_cosine, hn::Add(normal.y, one));
  return unit(d, Quaternions<V>{hn::Mul(normal.z, aside), hn::Zero(d), hn::Neg(hn::Mul(normal.x, aside)), along});
}

/// Returns the plane given, or a flat one where it is too steep or not finite.
template <class D, class V>
HWY_INLINE Footings<V> usable(D d, const Footings<V>& ground, V otherwise_height) {
  const V zero = hn::Zero(d);
  const Vectors<V> up = upwards(d, hn::Set(d, 1.0F));
  const Vectors<V> normal = unit_or(d, ground.normal, up);
  const auto slopes = hn::And(are_places(d, ground.place), hn::Gt(normal.y, hn::Set(d, steepest_ground)));
  const auto has_height = hn::Lt(hn::Abs(ground.place.y), hn::Set(d, farthest_place));
  const Vectors<V> flat{zero, hn::IfThenElse(has_height, ground.place.y, otherwise_height), zero};
  return {choose(slopes, ground.place, flat), choose(slopes, normal, up)};
}

template <class V>
HWY_INLINE Footings<V> to_model(const JointMotions<V>& model, const Footings<V>& footing) {
  const Quaternions<V> back = conjugate(model.rotation);
  return {rotated(back, difference(footing.place, model.position)), rotated(back, footing.normal)};
}

template <class V>
HWY_INLINE Vectors<V> to_world(const JointMotions<V>& model, const Vectors<V>& place) {
  return sum(model.position, rotated(model.rotation, place));
}

/// The goal of a foot, model space.
template <class V>
struct FootGoals {
  JointMotions<V> ankle;
  V planted;
};

/// Returns how firmly a foot is planted: as given, or by the height of its sole in the pose.
template <class D, class V>
HWY_INLINE V planted_share(D d, const PlacedBodies<D>& bodies, V planted, V lift) {
  const V zero = hn::Zero(d);
  const V range = hn::Sub(bodies.up_above, bodies.down_below);
  const V share = hn::Min(hn::Max(hn::Div(hn::Sub(bodies.up_above, lift), range), zero), hn::Set(d, 1.0F));
  return hn::IfThenElse(hn::Ge(planted, zero), planted, share);
}

/// Returns the goal of a foot. The footing of the ball is locked, so that the heel may rise and fall.
template <class D, class V>
HWY_INLINE FootGoals<V> goal_of(D d, const PlacedLeg& leg, const PlacedBodies<D>& bodies, const JointMotions<V>& ankle,
                                PlacedFeet<D>& foot) {
  const Soles<V> sole = sole_of(d, leg, ankle.rotation);
  const V lift = hn::Add(ankle.position.y, hn::Min(sole.heel.y, sole.ball.y));
  FootGoals<V> goal;
  goal.planted = planted_share(d, bodies, foot.planted, lift);

  const Footings<V> ground = usable(d, foot.ground, bodies.model_in_world.position.y);
  const Vectors<V> ball =
      to_world(bodies.model_in_world,
               Vectors<V>{hn::Add(ankle.position.x, sole.ball.x), hn::Zero(d), hn::Add(ankle.position.z, sole.ball.z)});
  const Footings<V> posed{{ball.x, ground_height(ground, ball.x, ball.z), ball.z}, ground.normal};
  const Footings<V> locked =
      to_model(bodies.model_in_world, step_foot_lock(d, foot.lock, posed, goal.planted, bodies.lock, bodies.seconds));

  goal.ankle.rotation = product(limited_tilt(d, locked.normal, bodies.least_tilt_cosine), ankle.rotation);
  const Soles<V> tilted = sole_of(d, leg, goal.ankle.rotation);
  const V x = hn::Sub(locked.place.x, tilted.ball.x);
  const V z = hn::Sub(locked.place.z, tilted.ball.z);
  const V above_ground = hn::Add(clearance(tilted, locked.normal), hn::NegMulAdd(lift, goal.planted, lift));
  goal.ankle.position = {x, hn::Add(ground_height(locked, x, z), hn::Div(above_ground, locked.normal.y)), z};
  return goal;
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
