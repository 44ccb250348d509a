#if defined(THRONG_KERNEL_BLEND_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_BLEND_INL_H
#undef THRONG_KERNEL_BLEND_INL_H
#else
#define THRONG_KERNEL_BLEND_INL_H
#endif

#include "engine/anim/kernel/kernels.h"
#include "engine/anim/kernel/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// normalise(from * (1 - w) + to * w), `to` taken on from's hemisphere: the sign goes into its weight.
template <class D, class V>
HWY_INLINE Quaternions<V> blend_rotations(D d, const Quaternions<V>& from, const Quaternions<V>& to, V weight) {
  const V from_weight = hn::Sub(hn::Set(d, 1.0F), weight);
  const V to_weight = hn::CopySignToAbs(weight, dot(from, to));
  const Quaternions<V> q{
      hn::MulAdd(to.x, to_weight, hn::Mul(from.x, from_weight)),
      hn::MulAdd(to.y, to_weight, hn::Mul(from.y, from_weight)),
      hn::MulAdd(to.z, to_weight, hn::Mul(from.z, from_weight)),
      hn::MulAdd(to.w, to_weight, hn::Mul(from.w, from_weight)),
  };
  return scaled(q, inverse_square_root(d, dot(q, q)));
}

inline void blend(const BlendJob& job) {
  const BoneLanes d;
  for (int bone = 0; bone < packet_bones; bone += lane_count<BoneLanes>) {
    auto weight = hn::Set(d, job.fraction);
    if (job.bone_weights != nullptr) weight = hn::Mul(weight, hn::Load(d, job.bone_weights + bone));
    const auto from = load_quaternions(d, job.from + bone, packet_bones);
    const auto to = load_quaternions(d, job.to + bone, packet_bones);
    store(d, blend_rotations(d, from, to, weight), job.out + bone, packet_bones);
    for (int component = 4; component < job.components; ++component) {
      const auto start = hn::Load(d, job.from + component * packet_bones + bone);
      const auto end = hn::Load(d, job.to + component * packet_bones + bone);
      hn::Store(hn::MulAdd(hn::Sub(end, start), weight, start), d, job.out + component * packet_bones + bone);
    }
  }
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
