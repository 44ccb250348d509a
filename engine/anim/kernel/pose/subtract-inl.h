#if defined(THRONG_KERNEL_SUBTRACT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_SUBTRACT_INL_H
#undef THRONG_KERNEL_SUBTRACT_INL_H
#else
#define THRONG_KERNEL_SUBTRACT_INL_H
#endif

#include <cassert>

#include "engine/anim/kernel/lanes/lanes-inl.h"
#include "engine/anim/kernel/pose/subtract.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

template <class D, class V = hn::Vec<D>>
HWY_INLINE void subtract_lanes(D d, const SubtractJob& job, int bone) {
  const auto pose = load_quaternions(d, job.pose + bone, packet_bones);
  const auto reference = load_quaternions(d, job.reference + bone, packet_bones);
  const auto between = product(conjugate(reference), pose);
  const V to_unit = inverse_square_root(d, dot(between, between));
  // Deltas are turned to the hemisphere of the identity, so that they can be blended.
  store(d, scaled(between, hn::CopySignToAbs(to_unit, between.w)), job.out + bone, packet_bones);
  for (int component = 4; component < job.components; ++component) {
    const int at = component * packet_bones + bone;
    const V value = hn::Load(d, job.pose + at);
    const V from = hn::Load(d, job.reference + at);
    const V ratio = hn::IfThenElse(hn::Eq(from, hn::Zero(d)), hn::Set(d, 1.0F), hn::Div(value, from));
    hn::Store(component < rigid_components ? hn::Sub(value, from) : ratio, d, job.out + at);
  }
}

inline void subtract(const SubtractJob& job) {
  assert(is_valid(job));
  for (int bone = 0; bone < packet_bones; bone += lane_count<BoneLanes>) subtract_lanes(BoneLanes(), job, bone);
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
