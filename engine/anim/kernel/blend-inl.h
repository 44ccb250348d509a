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

/// normalise(from * (1 - w) + to * w) of unit quaternions, `to` taken on from's hemisphere. How long the sum is follows
/// from the cosine between the two, so that both come in with shares, one of them with a sign, that make it unit.
template <class D, class V>
HWY_INLINE Quaternions<V> blend_rotations(D d, const Quaternions<V>& from, const Quaternions<V>& to, V weight) {
  const V one = hn::Set(d, 1.0F);
  const V from_weight = hn::Sub(one, weight);
  const V twice_both = hn::Mul(hn::Add(weight, weight), from_weight);
  const V cosine = dot(from, to);
  const V squared_length = hn::MulAdd(twice_both, hn::Abs(cosine), hn::Sub(one, twice_both));
  const V to_unit = inverse_length_of_blend(d, squared_length);
  const V from_share = hn::Mul(from_weight, to_unit);
  const V to_share = hn::CopySignToAbs(hn::Mul(weight, to_unit), cosine);
  return {
      hn::MulAdd(to.x, to_share, hn::Mul(from.x, from_share)), hn::MulAdd(to.y, to_share, hn::Mul(from.y, from_share)),
      hn::MulAdd(to.z, to_share, hn::Mul(from.z, from_share)), hn::MulAdd(to.w, to_share, hn::Mul(from.w, from_share))};
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
