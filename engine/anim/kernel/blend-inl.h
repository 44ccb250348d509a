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
  return scaled(q, inverse_length_of_blend(d, dot(q, q)));
}

/// A bone of weight 0 keeps the bits of `from`, one of weight 1 takes those of `to`: what a mask leaves out is
/// untouched.
template <class V, class M>
struct MaskedLanes {
  M all_from, all_to;

  HWY_INLINE V choose(V from, V to, V blended) const {
    return hn::IfThenElse(all_from, from, hn::IfThenElse(all_to, to, blended));
  }
  HWY_INLINE Quaternions<V> choose(const Quaternions<V>& from, const Quaternions<V>& to,
                                   const Quaternions<V>& blended) const {
    return {choose(from.x, to.x, blended.x), choose(from.y, to.y, blended.y), choose(from.z, to.z, blended.z),
            choose(from.w, to.w, blended.w)};
  }
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE void blend_masked_lanes(D d, const BlendJob& job, int bone) {
  const V weight = hn::Mul(hn::Set(d, job.fraction), hn::Load(d, job.bone_weights + bone));
  const MaskedLanes<V, hn::Mask<D>> lanes{hn::Eq(weight, hn::Zero(d)), hn::Eq(weight, hn::Set(d, 1.0F))};
  const auto from = load_quaternions(d, job.from + bone, packet_bones);
  const auto to = load_quaternions(d, job.to + bone, packet_bones);
  store(d, lanes.choose(from, to, blend_rotations(d, from, to, weight)), job.out + bone, packet_bones);
  for (int component = 4; component < job.components; ++component) {
    const V start = hn::Load(d, job.from + component * packet_bones + bone);
    const V end = hn::Load(d, job.to + component * packet_bones + bone);
    const V between = hn::MulAdd(hn::Sub(end, start), weight, start);
    hn::Store(lanes.choose(start, end, between), d, job.out + component * packet_bones + bone);
  }
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE void blend_lanes(D d, const BlendJob& job, int bone) {
  const V weight = hn::Set(d, job.fraction);
  const auto from = load_quaternions(d, job.from + bone, packet_bones);
  const auto to = load_quaternions(d, job.to + bone, packet_bones);
  store(d, blend_rotations(d, from, to, weight), job.out + bone, packet_bones);
  for (int component = 4; component < job.components; ++component) {
    const V start = hn::Load(d, job.from + component * packet_bones + bone);
    const V end = hn::Load(d, job.to + component * packet_bones + bone);
    hn::Store(hn::MulAdd(hn::Sub(end, start), weight, start), d, job.out + component * packet_bones + bone);
  }
}

inline void blend(const BlendJob& job) {
  const BoneLanes d;
  constexpr int step = lane_count<BoneLanes>;
  if (job.bone_weights != nullptr) {
    for (int bone = 0; bone < packet_bones; bone += step) blend_masked_lanes(d, job, bone);
  } else {
    for (int bone = 0; bone < packet_bones; bone += step) blend_lanes(d, job, bone);
  }
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
