#if defined(THRONG_KERNEL_NOISE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_NOISE_INL_H
#undef THRONG_KERNEL_NOISE_INL_H
#else
#define THRONG_KERNEL_NOISE_INL_H
#endif

#include <cassert>

#include "engine/anim/kernel/lanes/rotation_vector-inl.h"
#include "engine/anim/kernel/pose/noise.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

template <class VU>
HWY_INLINE VU folded(VU bits) {
  return hn::Xor(bits, hn::ShiftRight<16>(bits));
}

/// A value from -2^31 to 2^31 whose highest bits are the bits below `from_top`.
template <int from_top, class D, class V = hn::Vec<D>>
HWY_INLINE V value_in_bits(D d, hn::Vec<hn::RebindToSigned<D>> bits) {
  return hn::ConvertTo(d, hn::ShiftLeft<from_top>(bits));
}

/// Numbers of consecutive bones, mixed.
template <class D>
HWY_INLINE hn::Vec<hn::RebindToUnsigned<D>> spread_bones(D, int first_bone) {
  const hn::RebindToUnsigned<D> lanes;
  // Iota from 0 is a constant; from another start Highway goes through memory.
  const auto bones = hn::Add(hn::Iota(lanes, 0U), hn::Set(lanes, static_cast<std::uint32_t>(first_bone)));
  return folded(hn::Mul(bones, hn::Set(lanes, 0x9E3779B9U)));
}

/// Half the turns of bones between three lattice points, about each axis. Their values, -2^31 to 2^31, come from a
/// bijective mix of 32 bits, the first round of Wellons' lowbias32: keys and spread bones are mixed already, and the
/// values of no two bones or axes correlate by more than a tenth.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Vectors<V> half_turns(D d, const NoiseMoment& moment, hn::Vec<hn::RebindToUnsigned<D>> spread) {
  const hn::RebindToUnsigned<D> unsigned_lanes;
  const hn::RebindToSigned<D> signed_lanes;
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

/// from * (v, 1), made unit: rotates the unit `from` by twice the arc tangent of the length of v.
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

/// The bones of a packet from `bone` on, one a lane.
template <class D>
struct NoiseLanes {
  hn::Vec<hn::RebindToUnsigned<D>> spread;
  int bone;
  int left;  ///< bones from `bone` to the bone count; may be 0 or less
};

/// Each bone's share of the amplitude; 0 for none.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V weights_of(D d, const ShakenBones& bones, const NoiseLanes<D>& lanes) {
  const V weights = bones.bone_weights == nullptr ? hn::Set(d, 1.0F) : hn::Load(d, bones.bone_weights + lanes.bone);
  const int left = bones.moment->amplitude > 0.0F ? lanes.left : 0;
  return hn::IfThenElseZero(hn::Lt(hn::Iota(d, 0.0F), hn::Set(d, static_cast<float>(left))), weights);
}

template <bool small, class D>
HWY_INLINE void noise_lanes(D d, const ShakenBones& bones, const NoiseLanes<D>& lanes) {
  const NoiseMoment& moment = *bones.moment;
  const auto from = load_quaternions(d, bones.from + lanes.bone, packet_bones);
  const auto turns = half_turns(d, moment, lanes.spread);
  const bool everywhere = bones.bone_weights == nullptr && moment.amplitude > 0.0F && lane_count<D> <= lanes.left;
  if (everywhere) {
    store(d, turned_by<small>(d, from, turns), bones.out + lanes.bone, packet_bones);
  } else {
    const auto weights = weights_of(d, bones, lanes);
    const auto turned = turned_by<small>(d, from, scaled(turns, weights));
    store(d, choose(hn::Eq(weights, hn::Zero(d)), from, turned), bones.out + lanes.bone, packet_bones);
  }
}

inline void noise(const NoiseJob& shared) {
  assert(is_valid(shared));
  using D = BoneLanes;
  const NoiseJob job = shared;  // a copy, since the compiler would read the job again after each store
  for (int bone = 0; bone < packet_bones; bone += lane_count<D>) {
    const int first_bone = job.packet * packet_bones + bone;
    const NoiseLanes<D> lanes{spread_bones(D(), first_bone), bone, job.bone_count - first_bone};
    for (const ShakenBones& bones : job.characters) {
      if (bones.moment->amplitude <= small_amplitude) {
        noise_lanes<true>(D(), bones, lanes);
      } else {
        noise_lanes<false>(D(), bones, lanes);
      }
      if (bones.out != bones.from) copy_components(D(), bones.from + bone, bones.out + bone, 4, job.components);
    }
  }
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
