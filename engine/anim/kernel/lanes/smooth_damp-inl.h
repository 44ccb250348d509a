// The functions of smooth_damp.h, one value a lane.
#if defined(THRONG_KERNEL_SMOOTH_DAMP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_SMOOTH_DAMP_INL_H
#undef THRONG_KERNEL_SMOOTH_DAMP_INL_H
#else
#define THRONG_KERNEL_SMOOTH_DAMP_INL_H
#endif

#include "engine/anim/kernel/lanes/rotation_vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// DampedValue.
template <class V>
struct DampedValues {
  V value, velocity;
};

/// smooth_damp
template <class D, class V>
HWY_INLINE DampedValues<V> damped(D d, const DampedValues<V>& from, V target, V smooth_seconds, V seconds) {
  const V zero = hn::Zero(d);
  const V stiffness = hn::Div(hn::Set(d, 2.0F), smooth_seconds);
  constexpr float growth[] = {1.0F, 1.0F, 0.48F, 0.235F};
  const V decay = hn::Div(hn::Set(d, 1.0F), polynomial(d, hn::Mul(stiffness, seconds), growth));
  const V distance = hn::Sub(from.value, target);
  const V pull = hn::Mul(hn::MulAdd(stiffness, distance, from.velocity), seconds);
  const auto stands = hn::Le(seconds, zero);
  const V value = hn::IfThenElse(stands, from.value, hn::MulAdd(hn::Add(distance, pull), decay, target));
  const V velocity = hn::Mul(hn::NegMulAdd(stiffness, pull, from.velocity), decay);
  const auto beyond = hn::Lt(hn::Mul(hn::Sub(value, target), distance), zero);
  const auto there = hn::Or(beyond, hn::Le(smooth_seconds, zero));
  return {hn::IfThenElse(there, target, value), hn::IfThenElse(there, zero, velocity)};
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
