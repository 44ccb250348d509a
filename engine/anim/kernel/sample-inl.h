#if defined(THRONG_KERNEL_SAMPLE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_SAMPLE_INL_H
#undef THRONG_KERNEL_SAMPLE_INL_H
#else
#define THRONG_KERNEL_SAMPLE_INL_H
#endif

#include "engine/anim/kernel/kernels.h"
#include "engine/anim/kernel/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

using Words = hn::Repartition<std::int16_t, BoneLanes>;  // two a bone
using Sums = hn::RebindToSigned<BoneLanes>;
using Floats = hn::Vec<BoneLanes>;

/// from * (one - fraction) + to * fraction in integers, as floats times minus sample_fraction_one. The weights are kept
/// negative because 32768 does not fit 16 bits and -32768 does.
struct RowWeights {
  explicit RowWeights(std::int32_t fraction) : from(fraction - sample_fraction_one), to(-fraction) {}
  std::int32_t from;
  std::int32_t to;
};
constexpr float weights_unit = -1.0F / static_cast<float>(sample_fraction_one);

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE Floats weigh(std::int16_t from, std::int16_t to, RowWeights weights) {
  return hn::ConvertTo(BoneLanes(), hn::Set(Sums(), from * weights.from + to * weights.to));
}

HWY_INLINE void weigh_pair(const std::int16_t* from, const std::int16_t* to, int bone, RowWeights weights,
                           Floats& first, Floats& second) {
  const int word = bone / 4 * 8 + bone % 4;
  first = weigh(from[word], to[word], weights);
  second = weigh(from[word + 4], to[word + 4], weights);
}

HWY_INLINE Floats weigh_single(const std::int16_t* from, const std::int16_t* to, int bone, RowWeights weights) {
  return weigh(from[bone], to[bone], weights);
}

#else

HWY_INLINE Floats weigh(hn::Vec<Words> from_to_pairs, RowWeights weights) {
  const Sums sums;
  const auto both = static_cast<std::int32_t>((static_cast<std::uint32_t>(weights.from) & 0xFFFFU) |
                                              (static_cast<std::uint32_t>(weights.to) << 16U));
#if HWY_ARCH_X86
  auto unused = hn::Zero(sums);
  const auto weighed = hn::ReorderWidenMulAccumulate(sums, from_to_pairs, hn::BitCast(Words(), hn::Set(sums, both)),
                                                     hn::Zero(sums), unused);
#else
  const auto pairs = hn::BitCast(sums, from_to_pairs);
  const auto weighed = hn::Add(hn::Mul(hn::ShiftRight<16>(hn::ShiftLeft<16>(pairs)), hn::Set(sums, weights.from)),
                               hn::Mul(hn::ShiftRight<16>(pairs), hn::Set(sums, weights.to)));
#endif
  return hn::ConvertTo(BoneLanes(), weighed);
}

HWY_INLINE void weigh_pair(const std::int16_t* from, const std::int16_t* to, int bone, RowWeights weights,
                           Floats& first, Floats& second) {
  const Words words;
  const auto from_words = hn::LoadU(words, from + 2 * bone);
  const auto to_words = hn::LoadU(words, to + 2 * bone);
  first = weigh(hn::InterleaveLower(words, from_words, to_words), weights);
  second = weigh(hn::InterleaveUpper(words, from_words, to_words), weights);
}

HWY_INLINE Floats weigh_single(const std::int16_t* from, const std::int16_t* to, int bone, RowWeights weights) {
  const hn::RebindToUnsigned<BoneLanes> wide;
  const hn::Rebind<std::uint16_t, BoneLanes> narrow;
  const auto low = hn::PromoteTo(wide, hn::LoadU(narrow, reinterpret_cast<const std::uint16_t*>(from) + bone));
  const auto high = hn::PromoteTo(wide, hn::LoadU(narrow, reinterpret_cast<const std::uint16_t*>(to) + bone));
  return weigh(hn::BitCast(Words(), hn::Or(low, hn::ShiftLeft<16>(high))), weights);
}

#endif

HWY_INLINE const std::int16_t* group_words(const std::byte* row, std::int32_t offset) {
  return reinterpret_cast<const std::int16_t*>(row + offset);
}

/// 1 / length of what lies between two rows, times weights_unit / 32767: a polynomial in what the squared length lacks
/// of 1, which is at most a tenth (least_row_dot), to 3e-7.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V sampled_to_unit(D d, V squared_length) {
  constexpr float unit = weights_unit / 32767.0F;
  const V lack = hn::NegMulAdd(squared_length, hn::Set(d, unit * unit), hn::Set(d, 1.0F));
  V y = hn::MulAdd(lack, hn::Set(d, 0.37481848F * unit), hn::Set(d, 0.37095027F * unit));
  y = hn::MulAdd(lack, y, hn::Set(d, 0.50008201F * unit));
  return hn::MulAdd(lack, y, hn::Set(d, 0.99999975F * unit));
}

/// Between the two rows, of a packet whose rotations move; sampled_to_unit brings them to unit length.
HWY_INLINE Quaternions<Floats> moving_rotations(const SamplePoint& point, const SampledPacket& packet, int bone) {
  const RowWeights weights(point.fraction);
  const std::int16_t* from = group_words(point.from, packet.rotation_offset);
  const std::int16_t* to = group_words(point.to, packet.rotation_offset);
  Quaternions<Floats> q;
  weigh_pair(from, to, bone, weights, q.x, q.y);
  weigh_pair(from + 2 * packet_bones, to + 2 * packet_bones, bone, weights, q.z, q.w);
  return q;
}

/// The same, or constant; factor_to_unit brings them to unit length.
HWY_INLINE Quaternions<Floats> weighed_rotations(const SamplePoint& point, const SampledPacket& packet, int bone) {
  if (packet.rotation_offset < 0) return load_quaternions(BoneLanes(), &packet.rotation[0][0] + bone, packet_bones);
  return moving_rotations(point, packet, bone);
}

HWY_INLINE Floats factor_to_unit(const SampledPacket& packet, const Quaternions<Floats>& weighed) {
  const BoneLanes d;
  return packet.rotation_offset < 0 ? hn::Set(d, 1.0F) : sampled_to_unit(d, dot(weighed, weighed));
}

HWY_INLINE Quaternions<Floats> sampled_rotations(const SamplePoint& point, const SampledPacket& packet, int bone) {
  const Quaternions<Floats> q = weighed_rotations(point, packet, bone);
  return scaled(q, factor_to_unit(packet, q));
}

/// How positions, or scales, are stored: base + step * lane.
struct SampledRange {
  std::int32_t offset;
  const float (*base)[packet_bones];
  const float (*step)[packet_bones];
};
HWY_INLINE SampledRange positions_of(const SampledPacket& packet) {
  return {packet.position_offset, packet.position_base, packet.position_step};
}
HWY_INLINE SampledRange scales_of(const SampledPacket& packet) {
  return {packet.scale_offset, packet.scale_base, packet.scale_step};
}

HWY_INLINE Floats in_range(const SampledRange& range, int axis, int bone, Floats weighed) {
  const BoneLanes d;
  return hn::MulAdd(hn::Mul(weighed, hn::Set(d, weights_unit)), hn::Load(d, range.step[axis] + bone),
                    hn::Load(d, range.base[axis] + bone));
}

HWY_INLINE Vectors<Floats> sampled_vectors(const SamplePoint& point, const SampledRange& range, int bone) {
  if (range.offset < 0) return load_vectors(BoneLanes(), range.base[0] + bone, packet_bones);
  const RowWeights weights(point.fraction);
  const std::int16_t* from = group_words(point.from, range.offset);
  const std::int16_t* to = group_words(point.to, range.offset);
  Floats x, y;
  weigh_pair(from, to, bone, weights, x, y);
  const Floats z = weigh_single(from + 2 * packet_bones, to + 2 * packet_bones, bone, weights);
  return {in_range(range, 0, bone, x), in_range(range, 1, bone, y), in_range(range, 2, bone, z)};
}

/// Which components of a packet are wanted.
struct Wanted {
  bool positions;
  bool scales;
};

HWY_INLINE void sample_packet(const SamplePoint& point, const SampledPacket& packet, Wanted wanted, float* pose) {
  const BoneLanes d;
  for (int bone = 0; bone < packet_bones; bone += lane_count<BoneLanes>) {
    float* out = pose + bone;
    store(d, sampled_rotations(point, packet, bone), out, packet_bones);
    if (wanted.positions) {
      store(d, sampled_vectors(point, positions_of(packet), bone), out + 4 * packet_bones, packet_bones);
    }
    if (wanted.scales) {
      store(d, sampled_vectors(point, scales_of(packet), bone), out + 7 * packet_bones, packet_bones);
    }
  }
}

inline void sample(const SampleJob& job) {
  const Wanted wanted{.positions = true, .scales = job.stream->components == general_components};
  sample_packet(job.point, job.stream->packets()[job.packet], wanted, job.pose);
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
