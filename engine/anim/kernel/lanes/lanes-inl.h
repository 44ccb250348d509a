// The functions that all kernels are written in, compiled once for every SIMD target (Highway's foreach_target includes
// this file again and again, hence the toggled guard).
#if defined(THRONG_KERNEL_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_LANES_INL_H
#undef THRONG_KERNEL_LANES_INL_H
#else
#define THRONG_KERNEL_LANES_INL_H
#endif

#include <hwy/highway.h>

#include "engine/anim/base/pose.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A vector of the float lanes that the target has, at most `most`.
template <int most>
using LanesUpTo = hn::CappedTag<float, static_cast<std::size_t>(most)>;
using BoneLanes = LanesUpTo<packet_bones>;

template <class D>
inline constexpr int lane_count = static_cast<int>(hn::MaxLanes(D()));

template <int count>
using FloatArray = float[static_cast<std::size_t>(count)];

/// 1 / sqrt(x) to 4e-7 for x in any octave: Kadlec's seed and first step, then a Newton step whose factor splits the
/// error that is left evenly around zero. Highway's own approximation differs between targets; this does not.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V inverse_square_root(D d, V x) {
  const hn::RebindToSigned<D> bits;
  V y = hn::BitCast(d, hn::Sub(hn::Set(bits, 0x5F1FFFF9), hn::ShiftRight<1>(hn::BitCast(bits, x))));
  y = hn::Mul(hn::Mul(y, hn::Set(d, 0.703952253F)), hn::NegMulAdd(hn::Mul(x, y), y, hn::Set(d, 2.38924456F)));
  return hn::Mul(hn::Mul(y, hn::Set(d, 0.50000018F)), hn::NegMulAdd(hn::Mul(x, y), y, hn::Set(d, 3.0F)));
}

/// 1 / sqrt(x) for x from 1/2 to 1, to 4e-7, for the squared length of a blend of two unit quaternions on one
/// hemisphere. A cubic, then a Newton step whose error is split evenly around zero, scaled so that the step takes
/// three operations. Computes `count` side by side, step by step, so that none waits for its own sums.
template <std::size_t count, class D, class V>
HWY_INLINE void inverse_lengths_of_blends(D d, const V* x, V* y) {
  const V cubic = hn::Set(d, -0.75938344F), quadratic = hn::Set(d, 2.37379403F);
  const V linear = hn::Set(d, -2.88898049F), constant = hn::Set(d, 2.06789192F), newton = hn::Set(d, 1.88988179F);
  V step[count];
  for (std::size_t k = 0; k < count; ++k) y[k] = hn::MulAdd(x[k], cubic, quadratic);
  for (std::size_t k = 0; k < count; ++k) y[k] = hn::MulAdd(x[k], y[k], linear);
  for (std::size_t k = 0; k < count; ++k) y[k] = hn::MulAdd(x[k], y[k], constant);
  for (std::size_t k = 0; k < count; ++k) step[k] = hn::NegMulAdd(hn::Mul(x[k], y[k]), y[k], newton);
  for (std::size_t k = 0; k < count; ++k) y[k] = hn::Mul(y[k], step[k]);
}

template <class V>
struct Quaternions {
  V x, y, z, w;
};

/// Computes `count` dot products side by side, step by step.
template <std::size_t count, class V>
HWY_INLINE void dots(const Quaternions<V>* a, const Quaternions<V>* b, V* sums) {
  for (std::size_t k = 0; k < count; ++k) sums[k] = hn::Mul(a[k].x, b[k].x);
  for (std::size_t k = 0; k < count; ++k) sums[k] = hn::MulAdd(a[k].y, b[k].y, sums[k]);
  for (std::size_t k = 0; k < count; ++k) sums[k] = hn::MulAdd(a[k].z, b[k].z, sums[k]);
  for (std::size_t k = 0; k < count; ++k) sums[k] = hn::MulAdd(a[k].w, b[k].w, sums[k]);
}

template <class V>
HWY_INLINE V dot(const Quaternions<V>& a, const Quaternions<V>& b) {
  V sum;
  dots<1>(&a, &b, &sum);
  return sum;
}

template <class V>
HWY_INLINE Quaternions<V> scaled(const Quaternions<V>& q, V factor) {
  return {hn::Mul(q.x, factor), hn::Mul(q.y, factor), hn::Mul(q.z, factor), hn::Mul(q.w, factor)};
}

/// The inverse rotation, of unit quaternions.
template <class V>
HWY_INLINE Quaternions<V> conjugate(const Quaternions<V>& q) {
  return {hn::Neg(q.x), hn::Neg(q.y), hn::Neg(q.z), q.w};
}

template <class V, class M>
HWY_INLINE Quaternions<V> choose(M where, const Quaternions<V>& then, const Quaternions<V>& otherwise) {
  return {hn::IfThenElse(where, then.x, otherwise.x), hn::IfThenElse(where, then.y, otherwise.y),
          hn::IfThenElse(where, then.z, otherwise.z), hn::IfThenElse(where, then.w, otherwise.w)};
}

/// Rotation by b, then by a (Hamilton product a * b).
template <class V>
HWY_INLINE Quaternions<V> product(const Quaternions<V>& a, const Quaternions<V>& b) {
  return {
      hn::NegMulAdd(a.z, b.y, hn::MulAdd(a.y, b.z, hn::MulAdd(a.x, b.w, hn::Mul(a.w, b.x)))),
      hn::MulAdd(a.z, b.x, hn::MulAdd(a.y, b.w, hn::NegMulAdd(a.x, b.z, hn::Mul(a.w, b.y)))),
      hn::MulAdd(a.z, b.w, hn::NegMulAdd(a.y, b.x, hn::MulAdd(a.x, b.y, hn::Mul(a.w, b.z)))),
      hn::NegMulAdd(a.z, b.z, hn::NegMulAdd(a.y, b.y, hn::NegMulAdd(a.x, b.x, hn::Mul(a.w, b.w)))),
  };
}

template <class V>
struct Vectors {
  V x, y, z;
};

/// Three rows of three.
template <class V>
struct Matrices {
  Vectors<V> x, y, z;
};

template <class V>
HWY_INLINE Vectors<V> sum(const Vectors<V>& a, const Vectors<V>& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}

template <class V>
HWY_INLINE Vectors<V> difference(const Vectors<V>& a, const Vectors<V>& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

/// row * v + start
template <class V>
HWY_INLINE V dot_add(const Vectors<V>& row, const Vectors<V>& v, V start) {
  return hn::MulAdd(row.z, v.z, hn::MulAdd(row.y, v.y, hn::MulAdd(row.x, v.x, start)));
}

/// m * v + start
template <class V>
HWY_INLINE Vectors<V> transform_add(const Matrices<V>& m, const Vectors<V>& v, const Vectors<V>& start) {
  return {dot_add(m.x, v, start.x), dot_add(m.y, v, start.y), dot_add(m.z, v, start.z)};
}

inline constexpr float root_of_two = 1.41421356F;

/// The matrices of quaternions of length root_of_two. A matrix needs twice the products of two components of a unit
/// quaternion, which these products are.
template <class D, class V>
HWY_INLINE Matrices<V> rotation_matrices(D d, const Quaternions<V>& q) {
  const V one = hn::Set(d, 1.0F);
  const V without_x = hn::NegMulAdd(q.x, q.x, one);
  const V without_y = hn::NegMulAdd(q.y, q.y, one);
  const V xy = hn::Mul(q.x, q.y);
  const V xz = hn::Mul(q.x, q.z);
  const V yz = hn::Mul(q.y, q.z);
  return {{hn::NegMulAdd(q.z, q.z, without_y), hn::NegMulAdd(q.w, q.z, xy), hn::MulAdd(q.w, q.y, xz)},
          {hn::MulAdd(q.w, q.z, xy), hn::NegMulAdd(q.z, q.z, without_x), hn::NegMulAdd(q.w, q.x, yz)},
          {hn::NegMulAdd(q.w, q.y, xz), hn::MulAdd(q.w, q.x, yz), hn::NegMulAdd(q.y, q.y, without_x)}};
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE Vectors<V> broadcast_vector(D d, const float* xyz) {
  return {hn::Set(d, xyz[0]), hn::Set(d, xyz[1]), hn::Set(d, xyz[2])};
}

/// Loads and stores components that lie `stride` floats apart.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Quaternions<V> load_quaternions(D d, const float* from, int stride) {
  return {hn::Load(d, from), hn::Load(d, from + stride), hn::Load(d, from + 2 * stride),
          hn::Load(d, from + 3 * stride)};
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE Vectors<V> load_vectors(D d, const float* from, int stride) {
  return {hn::Load(d, from), hn::Load(d, from + stride), hn::Load(d, from + 2 * stride)};
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE Matrices<V> load_matrices(D d, const float* from, int stride) {
  return {load_vectors(d, from, stride), load_vectors(d, from + 3 * stride, stride),
          load_vectors(d, from + 6 * stride, stride)};
}

template <class D, class V>
HWY_INLINE void store(D d, const Quaternions<V>& q, float* to, int stride) {
  hn::Store(q.x, d, to);
  hn::Store(q.y, d, to + stride);
  hn::Store(q.z, d, to + 2 * stride);
  hn::Store(q.w, d, to + 3 * stride);
}

template <class D, class V>
HWY_INLINE void store(D d, const Vectors<V>& v, float* to, int stride) {
  hn::Store(v.x, d, to);
  hn::Store(v.y, d, to + stride);
  hn::Store(v.z, d, to + 2 * stride);
}

template <class D, class V>
HWY_INLINE void store(D d, const Matrices<V>& m, float* to, int stride) {
  store(d, m.x, to, stride);
  store(d, m.y, to + 3 * stride, stride);
  store(d, m.z, to + 6 * stride, stride);
}

/// Copies the components [begin, end) of a vector of bones.
template <class D>
HWY_INLINE void copy_components(D d, const float* from, float* to, int begin, int end) {
  for (int component = begin; component < end; ++component) {
    hn::Store(hn::Load(d, from + component * packet_bones), d, to + component * packet_bones);
  }
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
