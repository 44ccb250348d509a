#if defined(THRONG_KERNEL_NOISE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_NOISE_INL_H
#undef THRONG_KERNEL_NOISE_INL_H
#else
#define THRONG_KERNEL_NOISE_INL_H
#endif

#include "engine/anim/kernel/noise.h"
#include "engine/anim/kernel/rotation_vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

template <class VU>
HWY_INLINE VU folded(VU bits) {
  return hn::Xor(bits, hn::ShiftRight<16>(bits));
}

/// A value from -2^31 to 2^31 whose highest bits are those below `from_top`.
template <int from_top, class D, class V = hn::Vec<D>>
HWY_INLINE V value_in_bits(D d, hn::Vec<hn::RebindToSigned<D>> bits) {
  return hn::ConvertTo(d, hn::ShiftLeft<from_top>(bits));
}

/// The values, -2^31 to 2^31, of consecutive bones between three lattice points, one an axis. Each comes from a
/// bijective mix of 32 bits, the first round of Wellons' lowbias32: keys and spread bones are mixed already, and the
/// values of no two bones or axes correlate by more than a tenth.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Vectors<V> noise_values(D d, const NoiseMoment& moment, int first_bone) {
  const hn::RebindToUnsigned<D> unsigned_lanes;
  const hn::RebindToSigned<D> signed_lanes;
  // Counted from 0, which is a constant; counted from elsewhere Highway goes through memory.
  const auto bones =
      hn::Add(hn::Iota(unsigned_lanes, 0U), hn::Set(unsigned_lanes, static_cast<std::uint32_t>(first_bone)));
  const auto spread = folded(hn::Mul(bones, hn::Set(unsigned_lanes, 0x9E3779B9U)));
  Vectors<V> sum{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  for (std::size_t point = 0; point < 3; ++point) {
    const auto keyed = hn::Xor(spread, hn::Set(unsigned_lanes, moment.keys.data()[point]));
    const auto bits = hn::BitCast(signed_lanes, folded(hn::Mul(keyed, hn::Set(unsigned_lanes, 0x7FEB352DU))));
    const V share = hn::Set(d, moment.shares.data()[point]);
    sum = {hn::MulAdd(value_in_bits<0>(d, bits), share, sum.x), hn::MulAdd(value_in_bits<10>(d, bits), share, sum.y),
           hn::MulAdd(value_in_bits<20>(d, bits), share, sum.z)};
  }
  return sum;
}

/// Radians up to which a polynomial makes turns unit, to 1e-7.
inline constexpr float small_amplitude = 0.3F;
/// Taylor series of 1 / sqrt(1 + x).
inline constexpr float inverse_length_beyond_one[] = {1.0F, -0.5F, 0.375F, -0.3125F};

/// from * (v, 1), made unit: `from`, which is, turned by twice the arc tangent of v's length.
template <bool small, class D, class V>
HWY_INLINE Quaternions<V> turned_by(D d, const Quaternions<V>& from, const Vectors<V>& v) {
  const V square = dot(v, v);
  const V factor = small ? polynomial(d, square, inverse_length_beyond_one)
                         : inverse_square_root(d, hn::Add(square, hn::Set(d, 1.0F)));
  const Quaternions<V> turned{
      hn::NegMulAdd(from.z, v.y, hn::MulAdd(from.y, v.z, hn::MulAdd(from.w, v.x, from.x))),
      hn::MulAdd(from.z, v.x, hn::NegMulAdd(from.x, v.z, hn::MulAdd(from.w, v.y, from.y))),
      hn::NegMulAdd(from.y, v.x, hn::MulAdd(from.x, v.y, hn::MulAdd(from.w, v.z, from.z))),
      hn::NegMulAdd(from.z, v.z, hn::NegMulAdd(from.y, v.y, hn::NegMulAdd(from.x, v.x, from.w))),
  };
  return scaled(turned, factor);
}

/// Of the bones from `bone` on; 0 at and above the bone count.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V amplitudes_of(D d, const NoiseJob& job, int bone) {
  const V even = hn::Set(d, job.amplitude);
  const V amplitudes = job.bone_weights == nullptr ? even : hn::Mul(even, hn::Load(d, job.bone_weights + bone));
  const int left = job.bone_count - job.packet * packet_bones - bone;
  return hn::IfThenElseZero(hn::Lt(hn::Iota(d, 0.0F), hn::Set(d, static_cast<float>(left))), amplitudes);
}

template <bool small, class D, class V = hn::Vec<D>>
HWY_INLINE Quaternions<V> shaken(D d, const NoiseJob& job, const Quaternions<V>& from, int bone, V amplitude) {
  constexpr float half_axis_share = 0.288675135F;  // 1 / sqrt(12): three axes at their ends make half of the amplitude
  const auto values = noise_values(d, *job.moment, job.packet * packet_bones + bone);
  return turned_by<small>(d, from, scaled(values, hn::Mul(amplitude, hn::Set(d, half_axis_share * 0x1p-31F))));
}

template <bool small, class D, class V = hn::Vec<D>>
HWY_INLINE void noise_lanes(D d, const NoiseJob& job, int bone) {
  const auto from = load_quaternions(d, job.from + bone, packet_bones);
  const bool everywhere = job.bone_weights == nullptr && job.amplitude > 0.0F &&
                          job.packet * packet_bones + bone + lane_count<D> <= job.bone_count;
  if (everywhere) {
    store(d, shaken<small>(d, job, from, bone, hn::Set(d, job.amplitude)), job.out + bone, packet_bones);
  } else {
    const V amplitude = amplitudes_of(d, job, bone);
    const auto turned = shaken<small>(d, job, from, bone, amplitude);
    store(d, choose(hn::Eq(amplitude, hn::Zero(d)), from, turned), job.out + bone, packet_bones);
  }
  if (job.out != job.from) copy_components(d, job.from + bone, job.out + bone, 4, job.components);
}

inline void noise(const NoiseJob& job) {
  for (int bone = 0; bone < packet_bones; bone += lane_count<BoneLanes>) {
    if (job.amplitude <= small_amplitude) {
      noise_lanes<true>(BoneLanes(), job, bone);
    } else {
      noise_lanes<false>(BoneLanes(), job, bone);
    }
  }
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
