#if defined(THRONG_KERNEL_MIX_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_MIX_INL_H
#undef THRONG_KERNEL_MIX_INL_H
#else
#define THRONG_KERNEL_MIX_INL_H
#endif

#include <cassert>

#include "engine/anim/kernel/lanes/lanes-inl.h"
#include "engine/anim/kernel/pose/mix.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// The sources of a job whose weight is not 0, in their order.
struct WeighedSources {
  const float* of[most_mixed_sources];
  const float* bone_weights[most_mixed_sources];
  float weights[most_mixed_sources];
  int count = 0;

  explicit WeighedSources(const MixJob& job) {
    for (int source = 0; source < job.count; ++source) {
      if (job.weights[source] == 0.0F) continue;
      of[count] = job.sources[source];
      bone_weights[count] = job.bone_weights != nullptr ? job.bone_weights[source] : nullptr;
      weights[count++] = job.weights[source];
    }
  }
};

/// Shares of the sources in some bones. They sum to 1; the only source with a weight has exactly 1.
template <class D, class V = hn::Vec<D>>
struct MixShares {
  V of[most_mixed_sources];
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE MixShares<D> shares_of_bones(D d, const WeighedSources& sources, int bone) {
  MixShares<D> shares;
  V total = hn::Zero(d);
  for (int source = 0; source < sources.count; ++source) {
    const V weight = hn::Set(d, sources.weights[source]);
    const float* bone_weights = sources.bone_weights[source];
    shares.of[source] = bone_weights != nullptr ? hn::Mul(weight, hn::Load(d, bone_weights + bone)) : weight;
    total = hn::Add(total, shares.of[source]);
  }
  const V one = hn::Set(d, 1.0F);
  const auto weighed = hn::Ge(total, hn::Set(d, least_mixed_weight));
  const V to_share = hn::IfThenElseZero(weighed, hn::Div(one, total));
  for (int source = 0; source < sources.count; ++source) {
    const auto alone = hn::And(weighed, hn::Eq(shares.of[source], total));
    shares.of[source] = hn::IfThenElse(alone, one, hn::Mul(shares.of[source], to_share));
  }
  shares.of[0] = hn::IfThenElse(weighed, shares.of[0], one);
  return shares;
}

/// Sums start at 0, which is never -0, so a share of 0 changes no bit.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Quaternions<V> mix_rotations(D d, const WeighedSources& sources, const MixShares<D>& shares, int bone) {
  const V zero = hn::Zero(d);
  Quaternions<V> sum{zero, zero, zero, zero};
  for (int source = 0; source < sources.count; ++source) {
    const auto q = load_quaternions(d, sources.of[source] + bone, packet_bones);
    // Adding 0 turns a dot product of -0, which the first source may have, into 0, which changes no sign.
    const V factor = hn::CopySignToAbs(shares.of[source], hn::Add(dot(sum, q), zero));
    sum = {hn::MulAdd(q.x, factor, sum.x), hn::MulAdd(q.y, factor, sum.y), hn::MulAdd(q.z, factor, sum.z),
           hn::MulAdd(q.w, factor, sum.w)};
  }
  return scaled(sum, inverse_square_root(d, dot(sum, sum)));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V mix_component(D d, const WeighedSources& sources, const MixShares<D>& shares, int at) {
  V sum = hn::Zero(d);
  for (int source = 0; source < sources.count; ++source) {
    sum = hn::MulAdd(hn::Load(d, sources.of[source] + at), shares.of[source], sum);
  }
  return sum;
}

/// Returns the bits of a source that has the whole share, else `mixed`.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V sole_or(D d, const WeighedSources& sources, const MixShares<D>& shares, int at, V mixed) {
  for (int source = 0; source < sources.count; ++source) {
    const auto sole = hn::Eq(shares.of[source], hn::Set(d, 1.0F));
    mixed = hn::IfThenElse(sole, hn::Load(d, sources.of[source] + at), mixed);
  }
  return mixed;
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE void mix_masked_lanes(D d, const WeighedSources& sources, int components, int bone, float* out) {
  const MixShares<D> shares = shares_of_bones(d, sources, bone);
  const auto sole = [&](int component, V mixed)
                        HWY_ATTR { return sole_or(d, sources, shares, component * packet_bones + bone, mixed); };
  const auto q = mix_rotations(d, sources, shares, bone);
  store(d, Quaternions<V>{sole(0, q.x), sole(1, q.y), sole(2, q.z), sole(3, q.w)}, out + bone, packet_bones);
  for (int component = 4; component < components; ++component) {
    const int at = component * packet_bones + bone;
    hn::Store(sole(component, mix_component(d, sources, shares, at)), d, out + at);
  }
}

template <class D>
HWY_INLINE void mix_lanes(D d, const WeighedSources& sources, int components, int bone, float* out) {
  MixShares<D> shares;
  for (int source = 0; source < sources.count; ++source) shares.of[source] = hn::Set(d, sources.weights[source]);
  store(d, mix_rotations(d, sources, shares, bone), out + bone, packet_bones);
  for (int component = 4; component < components; ++component) {
    const int at = component * packet_bones + bone;
    hn::Store(mix_component(d, sources, shares, at), d, out + at);
  }
}

inline void mix(const MixJob& job) {
  assert(is_valid(job));
  const BoneLanes d;
  const WeighedSources sources(job);
  for (int bone = 0; bone < packet_bones; bone += lane_count<BoneLanes>) {
    if (sources.count <= 1) {
      const float* sole = sources.count == 1 ? sources.of[0] : job.sources[0];
      copy_components(d, sole + bone, job.out + bone, 0, job.components);
    } else if (job.bone_weights != nullptr) {
      mix_masked_lanes(d, sources, job.components, bone, job.out);
    } else {
      mix_lanes(d, sources, job.components, bone, job.out);
    }
  }
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
