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

/// The values, -1 to 1, of consecutive bones at a lattice point.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V lattice_values(D d, std::uint64_t key, int first_bone) {
  const hn::RebindToUnsigned<D> unsigned_lanes;
  const hn::RebindToSigned<D> signed_lanes;
  const auto bones = hn::Iota(unsigned_lanes, static_cast<std::uint32_t>(first_bone));
  const auto spread = hn::Mul(bones, hn::Set(unsigned_lanes, 0x9E3779B9U));
  const auto bits =
      mixed_bits(unsigned_lanes, hn::Xor(spread, hn::Set(unsigned_lanes, static_cast<std::uint32_t>(key))));
  const auto top = hn::ShiftRight<8>(hn::BitCast(signed_lanes, bits));
  return hn::Mul(hn::ConvertTo(d, top), hn::Set(d, 0x1p-23F));
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE V noise_values(D d, const NoiseJob& job, std::uint64_t axis, int first_bone) {
  const float t = job.point.fraction;
  const float shares[] = {0.5F * (1.0F - t) * (1.0F - t), 0.5F + t * (1.0F - t), 0.5F * t * t};
  const std::uint64_t seed_and_axis = chain_hash(job.seed, axis);
  V sum = hn::Zero(d);
  for (std::uint64_t point = 0; point < 3; ++point) {
    const std::uint64_t key = chain_hash(seed_and_axis, static_cast<std::uint64_t>(job.point.lattice) + point);
    sum = hn::MulAdd(lattice_values(d, key, first_bone), hn::Set(d, shares[point]), sum);
  }
  return sum;
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE void noise_lanes(D d, const NoiseJob& job, int bone) {
  constexpr float axis_share = 0.577350269F;  // 1 / sqrt(3): three axes at their ends make one amplitude
  const int first_bone = job.packet * packet_bones + bone;
  const V amplitude = hn::Load(d, job.amplitudes + bone);
  const Vectors<V> values{noise_values(d, job, 0, first_bone), noise_values(d, job, 1, first_bone),
                          noise_values(d, job, 2, first_bone)};
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
