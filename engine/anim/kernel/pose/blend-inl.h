#if defined(THRONG_KERNEL_BLEND_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_BLEND_INL_H
#undef THRONG_KERNEL_BLEND_INL_H
#else
#define THRONG_KERNEL_BLEND_INL_H
#endif

#include <cassert>

#include "engine/anim/kernel/lanes/lanes-inl.h"
#include "engine/anim/kernel/pose/blend.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// normalise(from * (1 - w) + to * w) of unit quaternions, `to` on the hemisphere of `from`. The length of the sum
/// follows from the cosine between the two, so the shares of both are scaled before the sum. Computes `count` pairs
/// side by side, step by step. `out` may be `from`.
template <std::size_t count, class D, class V>
HWY_INLINE void blend_rotations(D d, const Quaternions<V>* from, const Quaternions<V>* to, const V* weights,
                                Quaternions<V>* out) {
  const V one = hn::Set(d, 1.0F);
  V from_weights[count], twice_both[count], cosines[count], squared_lengths[count], to_unit[count];
  for (std::size_t k = 0; k < count; ++k) from_weights[k] = hn::Sub(one, weights[k]);
  for (std::size_t k = 0; k < count; ++k) twice_both[k] = hn::Mul(hn::Add(weights[k], weights[k]), from_weights[k]);
  dots<count>(from, to, cosines);
  for (std::size_t k = 0; k < count; ++k) {
    squared_lengths[k] = hn::MulAdd(twice_both[k], hn::Abs(cosines[k]), hn::Sub(one, twice_both[k]));
  }
  inverse_lengths_of_blends<count>(d, squared_lengths, to_unit);
  for (std::size_t k = 0; k < count; ++k) {
    const V to_share = hn::CopySignToAbs(hn::Mul(weights[k], to_unit[k]), cosines[k]);
    const Quaternions<V> share = scaled(from[k], hn::Mul(from_weights[k], to_unit[k]));
    out[k] = {hn::MulAdd(to[k].x, to_share, share.x), hn::MulAdd(to[k].y, to_share, share.y),
              hn::MulAdd(to[k].z, to_share, share.z), hn::MulAdd(to[k].w, to_share, share.w)};
  }
}

template <class D, class V>
HWY_INLINE Quaternions<V> blend_rotations(D d, const Quaternions<V>& from, const Quaternions<V>& to, V weight) {
  Quaternions<V> blended;
  blend_rotations<1>(d, &from, &to, &weight, &blended);
  return blended;
}

/// A bone of weight 0 has the bits of `from`, and one of weight 1 the bits of `to`, so a mask leaves all other
/// bones untouched.
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
  assert(is_valid(job));
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
