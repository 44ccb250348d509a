// Computes how a limb bends to bring its end to a target (two_bone_ik.h), one limb a lane.
#if defined(THRONG_KERNEL_LIMB_ANGLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_LIMB_ANGLES_INL_H
#undef THRONG_KERNEL_LIMB_ANGLES_INL_H
#else
#define THRONG_KERNEL_LIMB_ANGLES_INL_H
#endif

#include "engine/anim/kernel/lanes/directions-inl.h"
#include "engine/anim/kernel/limb/two_bone_ik.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// The goal of each limb, from TwoBoneIkJob.
template <class D>
struct LimbGoals {
  Vectors<hn::Vec<D>> target, pole;
  hn::Vec<D> weight, softness;
  Quaternions<hn::Vec<D>> end_rotation;
  hn::Mask<D> turns_end;
};

template <class V>
struct LimbPlaces {
  Vectors<V> upper, middle, end;
};

/// The rotations of the upper and the middle joint, model space.
template <class V>
struct LimbTurns {
  Quaternions<V> upper, middle;
};

template <class D, class V>
HWY_INLINE Matrices<V> frame_of(D d, const Vectors<V>& direction, const Vectors<V>& normal) {
  const Vectors<V> across = unit_or_perpendicular(d, perpendicular_part(normal, direction), direction);
  return {direction, across, cross(direction, across)};
}

/// Returns the rotation that brings a direction and a bend normal to another such pair.
template <class D, class V>
HWY_INLINE Quaternions<V> turn_pair(D d, const Vectors<V>& from, const Vectors<V>& from_normal, const Vectors<V>& to,
                                    const Vectors<V>& to_normal) {
  const Matrices<V> before = frame_of(d, from, from_normal);
  const Matrices<V> after = frame_of(d, to, to_normal);
  const auto row = [&](V along, V across, V aside) {
    return scaled_add(before.z, aside, scaled_add(before.y, across, scaled(before.x, along)));
  };
  return rotation_of(d, Matrices<V>{row(after.x.x, after.y.x, after.z.x), row(after.x.y, after.y.y, after.z.y),
                                    row(after.x.z, after.y.z, after.z.z)});
}

/// bend_normal, two_bone_ik.h.
template <class D, class V>
HWY_INLINE Vectors<V> bend_normal(D d, const Vectors<V>& first, const Vectors<V>& second, const Vectors<V>& hinge) {
  const V one = hn::Set(d, 1.0F);
  const Vectors<V> crossed = cross(first, second);
  const V beyond = hn::Sub(length_of(crossed), hn::Set(d, straight_below));
  const V share = hn::Mul(beyond, hn::Set(d, 1.0F / (bent_above - straight_below)));
  const V bent = hn::Min(hn::Max(share, hn::Zero(d)), one);
  return unit_or(d, scaled_add(unit_or(d, crossed, hinge), bent, scaled(hinge, hn::Sub(one, bent))), hinge);
}

/// Returns the distance of the end for a target at `distance`. It eases out towards the full length.
template <class D, class V>
HWY_INLINE V soft_reach(D d, V distance, V length, V softness, V posed_distance) {
  const V zero = hn::Zero(d);
  const V easing_from = hn::Max(hn::NegMulAdd(length, softness, length), hn::Min(posed_distance, length));
  const V room = hn::Sub(length, easing_from);
  const V beyond = hn::Sub(distance, easing_from);
  const V eased = hn::IfThenElseZero(hn::Gt(room, zero), hn::Div(hn::Mul(room, beyond), hn::Add(room, beyond)));
  return hn::IfThenElse(hn::Gt(beyond, zero), hn::Add(easing_from, eased), distance);
}

/// Returns the bend normal after a swing from one reach to another. A swing of half a turn is about the normal.
template <class D, class V>
HWY_INLINE Vectors<V> swung_normal(D d, const Vectors<V>& from, const Vectors<V>& to, const Vectors<V>& normal) {
  const auto opposite = hn::Lt(dot(from, to), hn::Set(d, -0.9999F));
  return choose(opposite, normal, rotated(shortest_turn(d, from, to), normal));
}

/// The direction of the middle joint: towards the pole, or as in the swung limb.
template <class D, class V>
HWY_INLINE Vectors<V> outward(D d, const Vectors<V>& reach, const Vectors<V>& kept_normal, const Vectors<V>& pole) {
  const V zero = hn::Zero(d);
  const Vectors<V> kept = unit_or_perpendicular(d, cross(reach, kept_normal), reach);
  const Vectors<V> to_pole = perpendicular_part(unit_or(d, pole, {zero, zero, zero}), reach);
  return choose(hn::Gt(dot(to_pole, to_pole), hn::Set(d, 1e-6F)), unit_or(d, to_pole, kept), kept);
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE LimbTurns<V> solve_limb(D d, const LimbGoals<D>& goals, const LimbPlaces<V>& posed,
                                   const Vectors<V>& hinge) {
  const V one = hn::Set(d, 1.0F);
  const Vectors<V> to_middle = difference(posed.middle, posed.upper);
  const Vectors<V> to_end = difference(posed.end, posed.middle);
  const Vectors<V> posed_way = difference(posed.end, posed.upper);
  const Vectors<V> way = difference(goals.target, posed.upper);
  const V first_length = length_of(to_middle);
  const V second_length = length_of(to_end);
  const V length = hn::Add(first_length, second_length);
  const Vectors<V> first = scaled(to_middle, hn::Div(one, first_length));
  const Vectors<V> second = scaled(to_end, hn::Div(one, second_length));
  const Vectors<V> posed_reach = unit_or(d, posed_way, first);
  const Vectors<V> reach = unit_or(d, way, posed_reach);

  const V excess = hn::Sub(first_length, second_length);
  const V nearest = hn::Max(hn::Abs(excess), hn::Mul(length, hn::Set(d, 1e-4F)));
  const V wanted = soft_reach(d, length_of(way), length, goals.softness, length_of(posed_way));
  const V distance = hn::Min(hn::Max(wanted, nearest), length);

  const Vectors<V> normal = bend_normal(d, first, second, hinge);
  const Vectors<V> out = outward(d, reach, swung_normal(d, posed_reach, reach, normal), goals.pole);

  // Law of cosines: the middle is `along` the line to the target and `aside` of it.
  const V unclamped = hn::Div(hn::MulAdd(distance, distance, hn::Mul(excess, length)), hn::Add(distance, distance));
  const V along = hn::Min(hn::Max(unclamped, hn::Neg(first_length)), first_length);
  const V square = hn::Mul(hn::Sub(first_length, along), hn::Add(first_length, along));
  const V aside = hn::Sqrt(hn::Max(square, hn::Zero(d)));
  const Vectors<V> new_normal = cross(out, reach);
  const Vectors<V> new_first = unit_or(d, scaled_add(out, aside, scaled(reach, along)), reach);
  const Vectors<V> rest = scaled_add(new_first, hn::Neg(first_length), scaled(reach, distance));
  const Vectors<V> new_second = unit_or(d, rest, reach);
  return {turn_pair(d, first, normal, new_first, new_normal), turn_pair(d, second, normal, new_second, new_normal)};
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
