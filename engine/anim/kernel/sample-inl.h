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

HWY_INLINE void sample_rotations(const SamplePoint& point, const SampledPacket& packet, float* out) {
  const BoneLanes d;
  if (packet.rotation_offset < 0) {
    for (int lane = 0; lane < 4 * packet_bones; lane += lane_count<BoneLanes>) {
      hn::Store(hn::Load(d, &packet.rotation[0][0] + lane), d, out + lane);
    }
    return;
  }
  const RowWeights weights(point.fraction);
  const std::int16_t* from = group_words(point.from, packet.rotation_offset);
  const std::int16_t* to = group_words(point.to, packet.rotation_offset);
  for (int bone = 0; bone < packet_bones; bone += lane_count<BoneLanes>) {
    Quaternions<Floats> q;
    weigh_pair(from, to, bone, weights, q.x, q.y);
    weigh_pair(from + 2 * packet_bones, to + 2 * packet_bones, bone, weights, q.z, q.w);
    // Negative, as the weights are.
    const Floats to_unit = hn::Neg(inverse_square_root(d, dot(q, q)));
    store(d, scaled(q, to_unit), out + bone, packet_bones);
  }
}

/// Positions or scales: base + step * lane.
HWY_INLINE void sample_vectors(const SamplePoint& point, std::int32_t offset, const float (*base)[packet_bones],
                               const float (*step)[packet_bones], float* out) {
  const BoneLanes d;
  if (offset < 0) {
    for (int lane = 0; lane < 3 * packet_bones; lane += lane_count<BoneLanes>) {
      hn::Store(hn::Load(d, &base[0][0] + lane), d, out + lane);
    }
    return;
  }
  const RowWeights weights(point.fraction);
  const std::int16_t* from = group_words(point.from, offset);
  const std::int16_t* to = group_words(point.to, offset);
  const Floats unit = hn::Set(d, weights_unit);
  for (int bone = 0; bone < packet_bones; bone += lane_count<BoneLanes>) {
    Vectors<Floats> v;
    weigh_pair(from, to, bone, weights, v.x, v.y);
    v.z = weigh_single(from + 2 * packet_bones, to + 2 * packet_bones, bone, weights);
    hn::Store(hn::MulAdd(hn::Mul(v.x, unit), hn::Load(d, step[0] + bone), hn::Load(d, base[0] + bone)), d, out + bone);
    hn::Store(hn::MulAdd(hn::Mul(v.y, unit), hn::Load(d, step[1] + bone), hn::Load(d, base[1] + bone)), d,
              out + packet_bones + bone);
    hn::Store(hn::MulAdd(hn::Mul(v.z, unit), hn::Load(d, step[2] + bone), hn::Load(d, base[2] + bone)), d,
              out + 2 * packet_bones + bone);
  }
}

inline void sample(const SampleJob& job) {
  const SampledPacket& packet = job.stream->packets()[job.packet];
  sample_rotations(job.point, packet, job.pose);
  sample_vectors(job.point, packet.position_offset, packet.position_base, packet.position_step,
                 job.pose + 4 * packet_bones);
  if (job.stream->components == general_components) {
    sample_vectors(job.point, packet.scale_offset, packet.scale_base, packet.scale_step, job.pose + 7 * packet_bones);
  }
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
