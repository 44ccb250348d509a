#if defined(THRONG_KERNEL_MIX_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_MIX_INL_H
#undef THRONG_KERNEL_MIX_INL_H
#else
#define THRONG_KERNEL_MIX_INL_H
#endif

#include "engine/anim/kernel/kernels.h"
#include "engine/anim/kernel/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// The sources' shares of 16 bones' lanes: they sum to 1, and a source that alone weighs anything has exactly 1.
template <class D, class V = hn::Vec<D>>
struct MixShares {
  V of[most_mixed_sources];

  HWY_INLINE MixShares(D d, const MixJob& job, int bone) {
    V total = hn::Zero(d);
    for (int source = 0; source < job.count; ++source) {
      const float* bone_weights = job.bone_weights != nullptr ? job.bone_weights[source] : nullptr;
      const V weight = hn::Set(d, job.weights[source]);
      of[source] = bone_weights != nullptr ? hn::Mul(weight, hn::Load(d, bone_weights + bone)) : weight;
      total = hn::Add(total, of[source]);
    }
    const V one = hn::Set(d, 1.0F);
    const auto weighed = hn::Ge(total, hn::Set(d, least_mixed_weight));
    const V to_share = hn::IfThenElseZero(weighed, hn::Div(one, total));
    for (int source = 0; source < job.count; ++source) {
      const V share = hn::Mul(of[source], to_share);
      of[source] = hn::IfThenElse(hn::And(weighed, hn::Eq(of[source], total)), one, share);
    }
    of[0] = hn::IfThenElse(weighed, of[0], one);
  }
};

/// Sums of what has a share, and the bits of what has all of it.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Quaternions<V> mix_rotations(D d, const MixJob& job, const MixShares<D>& shares, int bone) {
  const V zero = hn::Zero(d);
  Quaternions<V> sum{zero, zero, zero, zero};
  Quaternions<V> sole = sum;
  auto any_sole = hn::Lt(zero, zero);
  for (int source = 0; source < job.count; ++source) {
    const V share = shares.of[source];
    const auto q = load_quaternions(d, job.sources[source] + bone, packet_bones);
    const auto is_sole = hn::Eq(share, hn::Set(d, 1.0F));
    // Adding 0 turns a dot product of -0, of the first source, into one that keeps its sign.
    const V factor = hn::CopySignToAbs(share, hn::Add(dot(sum, q), zero));
    const Quaternions<V> with{hn::MulAdd(q.x, factor, sum.x), hn::MulAdd(q.y, factor, sum.y),
                              hn::MulAdd(q.z, factor, sum.z), hn::MulAdd(q.w, factor, sum.w)};
    sum = choose(hn::Eq(share, zero), sum, with);
    sole = choose(is_sole, q, sole);
    any_sole = hn::Or(any_sole, is_sole);
  }
  return choose(any_sole, sole, scaled(sum, inverse_square_root(d, dot(sum, sum))));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V mix_component(D d, const MixJob& job, const MixShares<D>& shares, int at) {
  const V zero = hn::Zero(d);
  V sum = zero;
  V sole = zero;
  auto any_sole = hn::Lt(zero, zero);
  for (int source = 0; source < job.count; ++source) {
    const V share = shares.of[source];
    const V value = hn::Load(d, job.sources[source] + at);
    const auto is_sole = hn::Eq(share, hn::Set(d, 1.0F));
    sum = hn::IfThenElse(hn::Eq(share, zero), sum, hn::MulAdd(value, share, sum));
    sole = hn::IfThenElse(is_sole, value, sole);
    any_sole = hn::Or(any_sole, is_sole);
  }
  return hn::IfThenElse(any_sole, sole, sum);
}

inline void mix(const MixJob& job) {
  const BoneLanes d;
  for (int bone = 0; bone < packet_bones; bone += lane_count<BoneLanes>) {
    const MixShares<BoneLanes> shares(d, job, bone);
    store(d, mix_rotations(d, job, shares, bone), job.out + bone, packet_bones);
    for (int component = 4; component < job.components; ++component) {
      const int at = component * packet_bones + bone;
      hn::Store(mix_component(d, job, shares, at), d, job.out + at);
    }
  }
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
