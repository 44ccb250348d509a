#if defined(THRONG_KERNEL_NOISE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_NOISE_INL_H
#undef THRONG_KERNEL_NOISE_INL_H
#else
#define THRONG_KERNEL_NOISE_INL_H
#endif

#include "engine/anim/base/hash.h"
#include "engine/anim/kernel/noise.h"
#include "engine/anim/kernel/rotation_vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

/// A bijective mix of 32 bits (Wellons' lowbias32).
template <class DU, class VU>
HWY_INLINE VU mixed_bits(DU d, VU bits) {
  bits = hn::Mul(hn::Xor(bits, hn::ShiftRight<16>(bits)), hn::Set(d, 0x7FEB352DU));
  bits = hn::Mul(hn::Xor(bits, hn::ShiftRight<15>(bits)), hn::Set(d, 0x846CA68BU));
  return hn::Xor(bits, hn::ShiftRight<16>(bits));
}

/// Ten bits from bit `low` up, as a value from -1 to 1.
template <int low, class D, class V = hn::Vec<D>>
HWY_INLINE V value_in_bits(D d, hn::Vec<hn::RebindToSigned<D>> bits) {
  return hn::Mul(hn::ConvertTo(d, hn::ShiftRight<22>(hn::ShiftLeft<22 - low>(bits))), hn::Set(d, 0x1p-9F));
}

/// The values, -1 to 1, of consecutive bones between three lattice points, one an axis.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Vectors<V> noise_values(D d, const NoiseJob& job, int first_bone) {
  const hn::RebindToUnsigned<D> unsigned_lanes;
  const hn::RebindToSigned<D> signed_lanes;
  // Counted from 0, which is a constant; counted from elsewhere Highway goes through memory.
  const auto bones =
      hn::Add(hn::Iota(unsigned_lanes, 0U), hn::Set(unsigned_lanes, static_cast<std::uint32_t>(first_bone)));
  const auto spread = hn::Mul(bones, hn::Set(unsigned_lanes, 0x9E3779B9U));
  const float t = job.point.fraction;
  const float shares[] = {0.5F * (1.0F - t) * (1.0F - t), 0.5F + t * (1.0F - t), 0.5F * t * t};
  Vectors<V> sum{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  for (std::uint64_t point = 0; point < 3; ++point) {
    const std::uint64_t key = chain_hash(job.seed, static_cast<std::uint64_t>(job.point.lattice) + point);
    const auto mixed =
        mixed_bits(unsigned_lanes, hn::Xor(spread, hn::Set(unsigned_lanes, static_cast<std::uint32_t>(key))));
    const auto bits = hn::BitCast(signed_lanes, mixed);
    const V share = hn::Set(d, shares[point]);
    sum = {hn::MulAdd(value_in_bits<0>(d, bits), share, sum.x), hn::MulAdd(value_in_bits<10>(d, bits), share, sum.y),
           hn::MulAdd(value_in_bits<20>(d, bits), share, sum.z)};
  }
  return sum;
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE void noise_lanes(D d, const NoiseJob& job, int bone) {
  constexpr float axis_share = 0.577350269F;  // 1 / sqrt(3): three axes at their ends make one amplitude
  const V amplitude = hn::Load(d, job.amplitudes + bone);
  const auto values = noise_values(d, job, job.packet * packet_bones + bone);
  const auto rotation = rotations_by(d, scaled(values, hn::Mul(amplitude, hn::Set(d, axis_share))));
  const auto from = load_quaternions(d, job.from + bone, packet_bones);
  const auto turned = renormalised(d, product(from, rotation));
  store(d, choose(hn::Eq(amplitude, hn::Zero(d)), from, turned), job.out + bone, packet_bones);
  copy_components(d, job.from + bone, job.out + bone, 4, job.components);
}

inline void noise(const NoiseJob& job) {
  for (int bone = 0; bone < packet_bones; bone += lane_count<BoneLanes>) noise_lanes(BoneLanes(), job, bone);
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
