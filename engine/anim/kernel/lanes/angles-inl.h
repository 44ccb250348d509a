// Angles and rotations from polynomials and IEEE divisions and square roots, with the same bits on every target.
#if defined(THRONG_KERNEL_ANGLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_ANGLES_INL_H
#undef THRONG_KERNEL_ANGLES_INL_H
#else
#define THRONG_KERNEL_ANGLES_INL_H
#endif

#include "engine/anim/kernel/lanes/rotation_vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// Minimax polynomial of the Cephes library, (atan(x) / x - 1) / x^2 over x^2, for 0 to tan(pi/8).
inline constexpr float arc_tangent_beyond[] = {-3.33329491539e-1F, 1.99777106478e-1F, -1.38776856032e-1F,
                                               8.05374449538e-2F};

/// Angle of the point (x, y) from the x axis, -pi to pi, to 3e-7; 0 for (0, 0).
template <class D, class V>
HWY_INLINE V angle_of(D d, V y, V x) {
  const V zero = hn::Zero(d);
  const V width = hn::Abs(x);
  const V height = hn::Abs(y);
  const V longer = hn::Max(width, height);
  const V shorter = hn::Min(width, height);
  const auto upper_half = hn::Gt(shorter, hn::Mul(longer, hn::Set(d, 0.41421356F)));
  const V over = hn::IfThenElse(upper_half, hn::Sub(shorter, longer), shorter);
  const V under = hn::IfThenElse(upper_half, hn::Add(shorter, longer), longer);
  const V tangent = hn::Div(over, under);
  const V square = hn::Mul(tangent, tangent);
  const V beyond = hn::Mul(polynomial(d, square, arc_tangent_beyond), hn::Mul(square, tangent));
  const V acute = hn::Add(hn::IfThenElse(upper_half, hn::Set(d, pi / 4), zero), hn::Add(tangent, beyond));
  const V from_axis = hn::IfThenElse(hn::Gt(height, width), hn::Sub(hn::Set(d, pi / 2), acute), acute);
  const V angle = hn::IfThenElse(hn::Lt(x, zero), hn::Sub(hn::Set(d, pi), from_axis), from_axis);
  return hn::IfThenElse(hn::Gt(longer, zero), hn::CopySign(angle, y), zero);
}

template <class V>
struct HalfAngle {
  V sine, cosine;
};

/// Returns sine and cosine of half an angle of -pi to pi, to 1e-7.
template <class D, class V>
HWY_INLINE HalfAngle<V> half_angle(D d, V angle) {
  const V half = hn::Mul(angle, hn::Set(d, 0.5F));
  const V square = hn::Mul(half, half);
  return {hn::Mul(half, polynomial(d, square, sine_over_angle)), polynomial(d, square, cosine)};
}

template <class V>
HWY_INLINE Vectors<V> cross(const Vectors<V>& a, const Vectors<V>& b) {
  return {hn::NegMulAdd(a.z, b.y, hn::Mul(a.y, b.z)), hn::NegMulAdd(a.x, b.z, hn::Mul(a.z, b.x)),
          hn::NegMulAdd(a.y, b.x, hn::Mul(a.x, b.y))};
}

/// v + 2 w (u x v) + 2 u x (u x v), with the unit quaternion q = (u, w).
template <class V>
HWY_INLINE Vectors<V> rotated(const Quaternions<V>& q, const Vectors<V>& v) {
  const Vectors<V> axis{q.x, q.y, q.z};
  const Vectors<V> once = cross(axis, v);
  const Vectors<V> twice_once = sum(once, once);
  const Vectors<V> aside = cross(axis, twice_once);
  return {hn::Add(hn::MulAdd(twice_once.x, q.w, v.x), aside.x), hn::Add(hn::MulAdd(twice_once.y, q.w, v.y), aside.y),
          hn::Add(hn::MulAdd(twice_once.z, q.w, v.z), aside.z)};
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE Quaternions<V> no_rotation(D d) {
  const V zero = hn::Zero(d);
  return {zero, zero, zero, hn::Set(d, 1.0F)};
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
