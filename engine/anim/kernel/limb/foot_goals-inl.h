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

/// Metres: no sole is lower.
inline constexpr float deepest_sole = -1e9F;

/// The least y of a normal. Steeper ground counts as flat, and so does ground that is not finite.
inline constexpr float steepest_ground = 0.2F;

/// The two ends of the sole, relative to the ankle: the heel, and the ground below the joint of the toes.
template <class V>
struct Soles {
  Vectors<V> heel, ball;
};

template <class D, class V>
HWY_INLINE Soles<V> sole_of(D d, const PlacedLeg& leg, const Quaternions<V>& foot, const Vectors<V>& normal) {
  const Vectors<V> toes = rotated(foot, broadcast_vector(d, &leg.sole[1].x));
  return {rotated(foot, broadcast_vector(d, &leg.sole[0].x)), scaled_add(normal, hn::Set(d, -leg.ball_height), toes)};
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

/// Holds how far a leg reaches, from where, in model space.
template <class V>
struct LegReaches {
  Vectors<V> hip;
  V length;
  V farthest;  ///< from the hip to the ankle, no straighter than the pose has it or than the reserve
};

template <class D, class V>
HWY_INLINE LegReaches<V> reach_of(D d, const Vectors<V>& hip, const Vectors<V>& knee, const Vectors<V>& ankle) {
  const V length = hn::Add(length_of(difference(knee, hip)), length_of(difference(ankle, knee)));
  const V reserved = hn::Mul(length, hn::Set(d, 1.0F - knee_reserve));
  return {hip, length, hn::Max(length_of(difference(ankle, hip)), reserved)};
}

/// Returns how far the hip must come down for the leg to reach an ankle.
template <class D, class V>
HWY_INLINE V needed_drop(D d, const LegReaches<V>& leg, const Vectors<V>& ankle) {
  const Vectors<V> away = difference(leg.hip, ankle);
  const V level = hn::MulAdd(away.z, away.z, hn::Mul(away.x, away.x));
  return hn::Sub(away.y, hn::Sqrt(hn::Max(hn::MulSub(leg.farthest, leg.farthest, level), hn::Zero(d))));
}

/// Returns the share, 0 to 1, of the way from a place to another that the leg reaches when its hip is lowered by
/// `drop`, for which it reaches the first.
template <class D, class V>
HWY_INLINE V reached_share(D d, const LegReaches<V>& leg, V drop, const Vectors<V>& from, const Vectors<V>& to) {
  const Vectors<V> start = difference(from, difference(leg.hip, upwards(d, drop)));
  const Vectors<V> way = difference(to, from);
  const V square = dot(way, way);
  const V along = dot(start, way);
  const V room = hn::Max(hn::MulSub(leg.farthest, leg.farthest, dot(start, start)), hn::Zero(d));
  const V root = hn::Sqrt(hn::MulAdd(square, room, hn::Mul(along, along)));
  return hn::Min(hn::Div(hn::Sub(root, along), hn::Max(square, hn::Set(d, 1e-12F))), hn::Set(d, 1.0F));
}

/// The goal of a foot, model space.
template <class V>
struct FootGoals {
  JointMotions<V> ankle;
  V planted;
  V drop;   ///< metres that the hip must come down for it
  V steps;  ///< metres that it is lifted on its way back
};

/// Returns how firmly a foot is planted: as given, or by the height of its sole in the pose.
template <class D, class V>
HWY_INLINE V planted_share(D d, const PlacedBodies<D>& bodies, V planted, V lift) {
  const V zero = hn::Zero(d);
  const V range = hn::Sub(bodies.up_above, bodies.down_below);
  const V share = hn::Min(hn::Max(hn::Div(hn::Sub(bodies.up_above, lift), range), zero), hn::Set(d, 1.0F));
  return hn::IfThenElse(hn::Ge(planted, zero), planted, share);
}

/// Returns how high a sole is at least where it does not stand. Where the host says when a foot stands, one in the air
/// keeps off the ground, which blends of a step and a standing leg do not; else the pose says how high it is.
template <class D, class V>
HWY_INLINE V least_air(D d, V leg_length, V planted) {
  const V clear = hn::Mul(leg_length, hn::Set(d, foot_clearance));
  return hn::IfThenElse(hn::Ge(planted, hn::Zero(d)), clear, hn::Set(d, deepest_sole));
}

/// Returns the goal of a foot. The footing of the ball is locked, so that the heel may rise and fall. The ground under
/// the foot says how far the hip comes down for it. A place that is still out of reach then, behind a body that walks
/// away, is approached as far as the leg goes, and its lock ends.
template <class D, class V>
HWY_INLINE FootGoals<V> goal_of(D d, const PlacedLeg& leg, const PlacedBodies<D>& bodies, const LegReaches<V>& reach,
                                const JointMotions<V>& ankle, PlacedFeet<D>& foot) {
  const Soles<V> sole = sole_of(d, leg, ankle.rotation, upwards(d, hn::Set(d, 1.0F)));
  const V lift = hn::Add(ankle.position.y, hn::Min(sole.heel.y, sole.ball.y));
  FootGoals<V> goal;
  goal.planted = planted_share(d, bodies, foot.planted, lift);

  const Footings<V> ground = usable(d, foot.ground, bodies.model_in_world.position.y);
  const Vectors<V> ball =
      to_world(bodies.model_in_world,
               Vectors<V>{hn::Add(ankle.position.x, sole.ball.x), hn::Zero(d), hn::Add(ankle.position.z, sole.ball.z)});
  const Footings<V> posed{{ball.x, ground_height(ground, ball.x, ball.z), ball.z}, ground.normal};
  const Footings<V> locked = to_model(bodies.model_in_world, step_foot_lock(d, foot.lock, posed, goal.planted,
                                                                            foot.reached, bodies.lock, bodies.seconds));

  goal.ankle.rotation = product(limited_tilt(d, locked.normal, bodies.least_tilt_cosine), ankle.rotation);
  const Soles<V> tilted = sole_of(d, leg, goal.ankle.rotation, locked.normal);
  const V clear = least_air(d, reach.length, foot.planted);
  goal.steps = rise_of_step(d, foot.lock, goal.planted, bodies.lock.release_seconds, clear);
  const V in_the_air = hn::Max(lift, clear);
  const V lifted = hn::Add(hn::NegMulAdd(in_the_air, goal.planted, in_the_air), goal.steps);
  const V above_ground = hn::Div(hn::Add(clearance(tilted, locked.normal), lifted), locked.normal.y);
  const auto ankle_over = [&](V ball_x, V ball_z) {
    const V x = hn::Sub(ball_x, tilted.ball.x);
    const V z = hn::Sub(ball_z, tilted.ball.z);
    return Vectors<V>{x, hn::Add(ground_height(locked, x, z), above_ground), z};
  };
  const Vectors<V> held = ankle_over(locked.place.x, locked.place.z);
  const Vectors<V> carried = ankle_over(hn::Add(ankle.position.x, sole.ball.x), hn::Add(ankle.position.z, sole.ball.z));
  const V held_drop = needed_drop(d, reach, held);
  const V reserve =
      hn::IfThenElse(hn::Ge(foot.planted, hn::Zero(d)), hn::Set(d, told_lock_reserve), hn::Set(d, lock_reserve));
  const V most_drop = hn::MulAdd(reach.length, reserve, hn::Max(needed_drop(d, reach, carried), hn::Zero(d)));
  const auto is_beyond = hn::Gt(held_drop, most_drop);
  const V share = reached_share(d, reach, most_drop, carried, held);
  foot.reached = hn::IfThenElse(is_beyond, share, hn::Set(d, 1.0F));
  goal.drop = hn::Min(held_drop, most_drop);
  goal.ankle.position = choose(is_beyond, scaled_add(difference(held, carried), share, carried), held);
  return goal;
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
