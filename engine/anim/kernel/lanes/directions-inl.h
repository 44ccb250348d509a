// The functions of rotations.h, one direction or rotation a lane.
#if defined(THRONG_KERNEL_DIRECTIONS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_DIRECTIONS_INL_H
#undef THRONG_KERNEL_DIRECTIONS_INL_H
#else
#define THRONG_KERNEL_DIRECTIONS_INL_H
#endif

#include "engine/anim/kernel/lanes/angles-inl.h"
#include "engine/anim/kernel/lanes/rotations.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

template <class V>
HWY_INLINE V length_of(const Vectors<V>& v) {
  return hn::Sqrt(dot(v, v));
}

template <class V, class M>
HWY_INLINE Vectors<V> choose(M where, const Vectors<V>& then, const Vectors<V>& otherwise) {
  return {hn::IfThenElse(where, then.x, otherwise.x), hn::IfThenElse(where, then.y, otherwise.y),
          hn::IfThenElse(where, then.z, otherwise.z)};
}

/// start + v * factor
template <class V>
HWY_INLINE Vectors<V> scaled_add(const Vectors<V>& v, V factor, const Vectors<V>& start) {
  return {hn::MulAdd(v.x, factor, start.x), hn::MulAdd(v.y, factor, start.y), hn::MulAdd(v.z, factor, start.z)};
}

/// is_place, rotations.h.
template <class D, class V>
HWY_INLINE hn::Mask<D> are_places(D d, const Vectors<V>& v) {
  const V farthest = hn::Set(d, farthest_place);
  return hn::And(hn::Lt(hn::Abs(v.x), farthest),
                 hn::And(hn::Lt(hn::Abs(v.y), farthest), hn::Lt(hn::Abs(v.z), farthest)));
}

/// `v` at length 1; `otherwise` where it is shorter than 1e-12 or longer than 1e18, or not finite.
template <class D, class V>
HWY_INLINE Vectors<V> unit_or(D d, const Vectors<V>& v, const Vectors<V>& otherwise) {
  const V square = dot(v, v);
  const auto has_direction = hn::And(hn::Ge(square, hn::Set(d, 1e-24F)), hn::Le(square, hn::Set(d, 1e36F)));
  return choose(has_direction, scaled(v, hn::Div(hn::Set(d, 1.0F), hn::Sqrt(square))), otherwise);
}

/// Returns the part of `v` that is perpendicular to `unit`.
template <class V>
HWY_INLINE Vectors<V> perpendicular_part(const Vectors<V>& v, const Vectors<V>& unit) {
  const V along = dot(v, unit);
  return {hn::NegMulAdd(unit.x, along, v.x), hn::NegMulAdd(unit.y, along, v.y), hn::NegMulAdd(unit.z, along, v.z)};
}

/// Some unit vector at a right angle to `unit`.
template <class D, class V>
HWY_INLINE Vectors<V> any_perpendicular(D d, const Vectors<V>& unit) {
  const V zero = hn::Zero(d);
  const V one = hn::Set(d, 1.0F);
  const auto beside_x = hn::Lt(hn::Abs(unit.x), hn::Set(d, 0.6F));
  const Vectors<V> axis{hn::IfThenElseZero(beside_x, one), hn::IfThenZeroElse(beside_x, one), zero};
  return unit_or(d, cross(unit, axis), {zero, zero, one});
}

/// `v` at length 1, or, where unit_or would take another, some unit vector at a right angle to `unit`.
template <class D, class V>
HWY_INLINE Vectors<V> unit_or_perpendicular(D d, const Vectors<V>& v, const Vectors<V>& unit) {
  return unit_or(d, v, any_perpendicular(d, unit));
}

/// Normalises a quaternion, whose length must not be 0.
template <class D, class V>
HWY_INLINE Quaternions<V> unit(D d, const Quaternions<V>& q) {
  return scaled(q, hn::Div(hn::Set(d, 1.0F), hn::Sqrt(dot(q, q))));
}

/// Returns the shortest rotation between unit vectors. They must not be opposite, or less than about a degree from
/// that.
template <class D, class V>
HWY_INLINE Quaternions<V> shortest_turn(D d, const Vectors<V>& from, const Vectors<V>& to) {
  const Vectors<V> crossed = cross(from, to);
  return unit(d, Quaternions<V>{crossed.x, crossed.y, crossed.z, hn::Add(dot(from, to), hn::Set(d, 1.0F))});
}

/// Returns the rotation of a matrix. Of the four formulas it takes the one with the largest divisor.
template <class D, class V>
HWY_INLINE Quaternions<V> rotation_of(D d, const Matrices<V>& m) {
  const V one = hn::Set(d, 1.0F);
  const V sum_xy = hn::Add(m.x.x, m.y.y);
  const V difference_xy = hn::Sub(m.x.x, m.y.y);
  const V four_ww = hn::Add(hn::Add(one, sum_xy), m.z.z);
  const V four_xx = hn::Sub(hn::Add(one, difference_xy), m.z.z);
  const V four_yy = hn::Sub(hn::Sub(one, difference_xy), m.z.z);
  const V four_zz = hn::Add(hn::Sub(one, sum_xy), m.z.z);
  const V four_wx = hn::Sub(m.z.y, m.y.z);
  const V four_wy = hn::Sub(m.x.z, m.z.x);
  const V four_wz = hn::Sub(m.y.x, m.x.y);
  const V four_xy = hn::Add(m.y.x, m.x.y);
  const V four_xz = hn::Add(m.x.z, m.z.x);
  const V four_yz = hn::Add(m.z.y, m.y.z);
  const Quaternions<V> by_w_or_x = choose(hn::Ge(four_ww, four_xx), Quaternions<V>{four_wx, four_wy, four_wz, four_ww},
                                          Quaternions<V>{four_xx, four_xy, four_xz, four_wx});
  const Quaternions<V> by_y_or_z = choose(hn::Ge(four_yy, four_zz), Quaternions<V>{four_xy, four_yy, four_yz, four_wy},
                                          Quaternions<V>{four_xz, four_yz, four_zz, four_wz});
  return unit(d, choose(hn::Ge(hn::Max(four_ww, four_xx), hn::Max(four_yy, four_zz)), by_w_or_x, by_y_or_z));
}

/// Interpolates over the shorter arc: 0 gives `from`, 1 gives `to` or its negative. The result is unit.
template <class D, class V>
HWY_INLINE Quaternions<V> mix_rotations(D d, const Quaternions<V>& from, const Quaternions<V>& to, V weight) {
  const V side = hn::IfThenElse(hn::Lt(dot(from, to), hn::Zero(d)), hn::Neg(weight), weight);
  const V rest = hn::Sub(hn::Set(d, 1.0F), weight);
  return unit(
      d, Quaternions<V>{hn::MulAdd(to.x, side, hn::Mul(from.x, rest)), hn::MulAdd(to.y, side, hn::Mul(from.y, rest)),
                        hn::MulAdd(to.z, side, hn::Mul(from.z, rest)), hn::MulAdd(to.w, side, hn::Mul(from.w, rest))});
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
