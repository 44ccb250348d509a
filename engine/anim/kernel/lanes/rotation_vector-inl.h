// Converts between unit quaternions and rotation vectors (axis times angle, rad), with the same bits on every target.
#if defined(THRONG_KERNEL_ROTATION_VECTOR_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_ROTATION_VECTOR_INL_H
#undef THRONG_KERNEL_ROTATION_VECTOR_INL_H
#else
#define THRONG_KERNEL_ROTATION_VECTOR_INL_H
#endif

#include "engine/anim/kernel/lanes/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

inline constexpr float pi = 3.14159265F;

/// c[0] + c[1] x + c[2] x^2 + ...
template <class D, class V, std::size_t count>
HWY_INLINE V polynomial(D d, V x, const float (&coefficients)[count]) {
  V value = hn::Set(d, coefficients[count - 1]);
  for (std::size_t i = count - 1; i > 0; --i) value = hn::MulAdd(value, x, hn::Set(d, coefficients[i - 1]));
  return value;
}

/// Minimax over the square of 0 to sqrt(1/2), or of 0 to pi/2, to 5e-8.
inline constexpr float arcsine_over_sine[] = {1.0F,          0.166670382F,  0.0748542473F,  0.0468072593F,
                                              0.0148486393F, 0.0811067745F, -0.0982398614F, 0.114361517F};
inline constexpr float sine_over_angle[] = {1.0F, -0.166666582F, 0.00833305065F, -0.000198090696F, 2.60521028e-06F};
inline constexpr float cosine[] = {1.0F, -0.5F, 0.0416666381F, -0.00138883607F, 2.47601529e-05F, -2.60513474e-07F};

template <class V>
HWY_INLINE V dot(const Vectors<V>& a, const Vectors<V>& b) {
  return hn::MulAdd(a.z, b.z, hn::MulAdd(a.y, b.y, hn::Mul(a.x, b.x)));
}

template <class V>
HWY_INLINE Vectors<V> scaled(const Vectors<V>& v, V factor) {
  return {hn::Mul(v.x, factor), hn::Mul(v.y, factor), hn::Mul(v.z, factor)};
}

/// Shortens vectors longer than `most` to it; others keep their bits.
template <class D, class V>
HWY_INLINE Vectors<V> no_longer_than(D d, const Vectors<V>& v, float most) {
  const V fits = hn::Mul(hn::Set(d, most), inverse_square_root(d, dot(v, v)));
  return scaled(v, hn::Min(fits, hn::Set(d, 1.0F)));
}

/// q of length 1 to a thousandth, made unit to float precision: one Newton step from 1.
template <class D, class V>
HWY_INLINE Quaternions<V> renormalised(D d, const Quaternions<V>& q) {
  return scaled(q, hn::NegMulAdd(dot(q, q), hn::Set(d, 0.5F), hn::Set(d, 1.5F)));
}

/// The logarithm: q and -q give the two arcs, angles of 0 to pi where w >= 0 and of pi to 2 pi elsewhere.
template <class D, class V>
HWY_INLINE Vectors<V> rotation_vectors(D d, const Quaternions<V>& q) {
  const Vectors<V> axis{q.x, q.y, q.z};
  const V sine_square = dot(axis, axis);
  const V cosine_square = hn::Mul(q.w, q.w);
  const V seed = inverse_square_root(d, sine_square);
  const V error = hn::NegMulAdd(hn::Mul(sine_square, seed), seed, hn::Set(d, 1.0F));
  const V over_sine = hn::MulAdd(hn::Mul(seed, hn::Set(d, 0.5F)), error, seed);
  // Takes the arcsine of the smaller of sine and cosine, where its slope is small.
  const V ratio = polynomial(d, hn::Min(sine_square, cosine_square), arcsine_over_sine);
  const V beside_axis = hn::Mul(hn::NegMulAdd(q.w, ratio, hn::Set(d, pi / 2)), over_sine);
  const V beyond = hn::MulSub(hn::Set(d, pi), over_sine, ratio);
  const V along = hn::IfThenElse(hn::Lt(q.w, hn::Zero(d)), beyond, ratio);
  const V half_angle_over_sine = hn::IfThenElse(hn::Lt(cosine_square, sine_square), beside_axis, along);
  return scaled(axis, hn::Add(half_angle_over_sine, half_angle_over_sine));
}

/// The exponential: the unit quaternion, w >= 0, of a rotation vector, which is cut to half a turn.
template <class D, class V>
HWY_INLINE Quaternions<V> rotations_by(D d, const Vectors<V>& rotation) {
  const V half = hn::Set(d, 0.5F);
  const Vectors<V> half_angle = scaled(no_longer_than(d, rotation, pi), half);
  const V square = dot(half_angle, half_angle);
  const Vectors<V> axis = scaled(half_angle, polynomial(d, square, sine_over_angle));
  return {axis.x, axis.y, axis.z, polynomial(d, square, cosine)};
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
