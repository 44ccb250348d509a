#if defined(THRONG_KERNEL_ADD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_ADD_INL_H
#undef THRONG_KERNEL_ADD_INL_H
#else
#define THRONG_KERNEL_ADD_INL_H
#endif

#include <cassert>

#include "engine/anim/kernel/lanes/lanes-inl.h"
#include "engine/anim/kernel/pose/add.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// Identity to delta, linear and not yet normalised: identity * (1 - w) + (delta on its hemisphere) * w.
template <class D, class V>
HWY_INLINE Quaternions<V> share_of_delta(D d, const Quaternions<V>& delta, V weight) {
  const V toward = hn::CopySignToAbs(weight, delta.w);
  const V identity_weight = hn::Sub(hn::Set(d, 1.0F), weight);
  return {hn::Mul(delta.x, toward), hn::Mul(delta.y, toward), hn::Mul(delta.z, toward),
          hn::MulAdd(delta.w, toward, identity_weight)};
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE void add_lanes(D d, const AddJob& job, int bone) {
  const V bone_weight = job.bone_weights != nullptr ? hn::Load(d, job.bone_weights + bone) : hn::Set(d, 1.0F);
  const V weight = hn::Mul(hn::Set(d, job.weight), bone_weight);
  const auto untouched = hn::Eq(weight, hn::Zero(d));
  const auto base = load_quaternions(d, job.base + bone, packet_bones);
  const auto delta = load_quaternions(d, job.delta + bone, packet_bones);
  const auto turned = product(base, share_of_delta(d, delta, weight));
  const auto unit = scaled(turned, inverse_square_root(d, dot(turned, turned)));
  store(d, choose(untouched, base, unit), job.out + bone, packet_bones);
  for (int component = 4; component < job.components; ++component) {
    const int at = component * packet_bones + bone;
    const V from = hn::Load(d, job.base + at);
    const V change = hn::Load(d, job.delta + at);
    const V one = hn::Set(d, 1.0F);
    const V moved = hn::MulAdd(change, weight, from);
    const V stretched = hn::Mul(from, hn::MulAdd(hn::Sub(change, one), weight, one));
    hn::Store(hn::IfThenElse(untouched, from, component < rigid_components ? moved : stretched), d, job.out + at);
  }
}

inline void add(const AddJob& job) {
  assert(is_valid(job));
  for (int bone = 0; bone < packet_bones; bone += lane_count<BoneLanes>) add_lanes(BoneLanes(), job, bone);
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
