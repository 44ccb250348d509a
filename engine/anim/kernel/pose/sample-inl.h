#if defined(THRONG_KERNEL_SAMPLE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_SAMPLE_INL_H
#undef THRONG_KERNEL_SAMPLE_INL_H
#else
#define THRONG_KERNEL_SAMPLE_INL_H
#endif

#include <bit>
#include <cassert>

#include "engine/anim/kernel/lanes/lanes-inl.h"
#include "engine/anim/kernel/pose/sample.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

using Words = hn::Repartition<std::int16_t, BoneLanes>;  // two a bone
using Sums = hn::RebindToSigned<BoneLanes>;
using Floats = hn::Vec<BoneLanes>;

// Rows are weighed in integers (row_weights): weigh interpolates two, in units of row_weight_unit.

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE Floats weigh(std::int16_t from, std::int16_t to, std::uint32_t weights) {
  const int of_from = static_cast<std::int16_t>(weights), of_to = static_cast<std::int16_t>(weights >> 16U);
  return hn::ConvertTo(BoneLanes(), hn::Set(Sums(), from * of_from + to * of_to));
}

HWY_INLINE void weigh_pair(const std::int16_t* from, const std::int16_t* to, int bone, std::uint32_t weights,
                           Floats& first, Floats& second) {
  const int word = bone / 4 * 8 + bone % 4;
  first = weigh(from[word], to[word], weights);
  second = weigh(from[word + 4], to[word + 4], weights);
}

HWY_INLINE Floats weigh_lanes(const std::int16_t* from, const std::int16_t* to, int lane, std::uint32_t weights) {
  return weigh(from[lane], to[lane], weights);
}

/// Stores lanes of a quad from `lane` on into the planes of x, y and z, which begin at `planes`.
template <class D>
HWY_INLINE void store_quad(D d, hn::Vec<D> value, int lane, float* planes) {
  hn::Store(value, d, planes + lane / quad_bones * packet_bones + lane % quad_bones);
}

#else

HWY_INLINE Floats weigh(hn::Vec<Words> from_to_pairs, std::uint32_t weights) {
  const Sums sums;
  const auto both = hn::Set(sums, static_cast<std::int32_t>(weights));
#if HWY_ARCH_X86
  auto unused = hn::Zero(sums);
  const auto weighed =
      hn::ReorderWidenMulAccumulate(sums, from_to_pairs, hn::BitCast(Words(), both), hn::Zero(sums), unused);
#else
  const auto lower = [](auto words) { return hn::ShiftRight<16>(hn::ShiftLeft<16>(words)); };
  const auto pairs = hn::BitCast(sums, from_to_pairs);
  const auto weighed =
      hn::Add(hn::Mul(lower(pairs), lower(both)), hn::Mul(hn::ShiftRight<16>(pairs), hn::ShiftRight<16>(both)));
#endif
  return hn::ConvertTo(BoneLanes(), weighed);
}

HWY_INLINE void weigh_pair(const std::int16_t* from, const std::int16_t* to, int bone, std::uint32_t weights,
                           Floats& first, Floats& second) {
  const Words words;
  const auto from_words = hn::LoadU(words, from + 2 * bone);
  const auto to_words = hn::LoadU(words, to + 2 * bone);
  first = weigh(hn::InterleaveLower(words, from_words, to_words), weights);
  second = weigh(hn::InterleaveUpper(words, from_words, to_words), weights);
}

HWY_INLINE Floats weigh_lanes(const std::int16_t* from, const std::int16_t* to, int lane, std::uint32_t weights) {
  const hn::RebindToUnsigned<BoneLanes> wide;
  const hn::Rebind<std::uint16_t, BoneLanes> narrow;
  const auto low = hn::PromoteTo(wide, hn::LoadU(narrow, reinterpret_cast<const std::uint16_t*>(from) + lane));
  const auto high = hn::PromoteTo(wide, hn::LoadU(narrow, reinterpret_cast<const std::uint16_t*>(to) + lane));
  return weigh(hn::BitCast(Words(), hn::Or(low, hn::ShiftLeft<16>(high))), weights);
}

template <class D>
HWY_INLINE void store_quad(D d, hn::Vec<D> lanes, int lane, float* planes) {
  if constexpr (quad_bones < lane_count<D>) {
    const hn::Half<D> half;
    store_quad(half, hn::LowerHalf(half, lanes), lane, planes);
    store_quad(half, hn::UpperHalf(half, lanes), lane + lane_count<D> / 2, planes);
  } else if (lane < 3 * quad_bones) {
    hn::Store(lanes, d, planes + lane / quad_bones * packet_bones);
  }
}

#endif

HWY_INLINE const std::int16_t* group_words(const std::byte* row, std::int32_t offset) {
  return reinterpret_cast<const std::int16_t*>(row + offset);
}

/// 1 / length of an interpolation of two rows, times row_weight_unit / quantised_one, to 3e-7: a polynomial in 1 less
/// the squared length, which is at most a tenth (least_row_dot). Computes `count` side by side, step by step.
template <std::size_t count, class D, class V>
HWY_INLINE void sampled_to_unit(D d, const V* squared_lengths, V* factors) {
  constexpr float unit = row_weight_unit / quantised_one;
  const V one = hn::Set(d, 1.0F), square = hn::Set(d, unit * unit);
  const V cubic = hn::Set(d, 0.37481848F * unit), quadratic = hn::Set(d, 0.37095027F * unit);
  const V linear = hn::Set(d, 0.50008201F * unit), constant = hn::Set(d, 0.99999975F * unit);
  V lack[count];
  for (std::size_t k = 0; k < count; ++k) lack[k] = hn::NegMulAdd(squared_lengths[k], square, one);
  for (std::size_t k = 0; k < count; ++k) factors[k] = hn::MulAdd(lack[k], cubic, quadratic);
  for (std::size_t k = 0; k < count; ++k) factors[k] = hn::MulAdd(lack[k], factors[k], linear);
  for (std::size_t k = 0; k < count; ++k) factors[k] = hn::MulAdd(lack[k], factors[k], constant);
}

/// Interpolates the rows of a packet whose rotations move. sampled_to_unit brings the result to unit length. Lanes
/// that the rows do not store get the bytes behind them; with_identity_behind replaces it.
HWY_INLINE Quaternions<Floats> moving_rotations(const SamplePoint& point, const SampledPacket& packet, int bone) {
  const std::int16_t* from = group_words(point.from, packet.rotation_offset);
  const std::int16_t* to = group_words(point.to, packet.rotation_offset);
  Quaternions<Floats> q;
  const std::ptrdiff_t to_zw = std::ptrdiff_t{2} * packet.lanes;
  weigh_pair(from, to, bone, point.weights, q.x, q.y);
  weigh_pair(from + to_zw, to + to_zw, bone, point.weights, q.z, q.w);
  return q;
}

/// The same for a packet that moves or stands still. factor_to_unit brings the result to unit length.
HWY_INLINE Quaternions<Floats> weighed_rotations(const SamplePoint& point, const SampledPacket& packet, int bone) {
  if (packet.rotation_offset < 0) {
    const auto& constants = packet.at<PacketRotations>(packet.rotation_constants);
    return load_quaternions(BoneLanes(), &constants.lanes[0][0] + bone, packet_bones);
  }
  return moving_rotations(point, packet, bone);
}

HWY_INLINE Floats factor_to_unit(const SampledPacket& packet, const Quaternions<Floats>& weighed) {
  const BoneLanes d;
  if (packet.rotation_offset < 0) return hn::Set(d, 1.0F);
  const Floats squared_length = dot(weighed, weighed);
  Floats factor;
  sampled_to_unit<1>(d, &squared_length, &factor);
  return factor;
}

/// Puts the identity into the lanes that the rows of a packet do not store. The first lane belongs to `bone`.
HWY_INLINE Quaternions<Floats> with_identity_behind(const SampledPacket& packet, int bone,
                                                    const Quaternions<Floats>& q) {
  const BoneLanes d;
  if (packet.lanes == packet_bones) return q;
  const auto held = hn::FirstN(d, static_cast<std::size_t>(HWY_MAX(packet.lanes - bone, 0)));
  return {hn::IfThenElseZero(held, q.x), hn::IfThenElseZero(held, q.y), hn::IfThenElseZero(held, q.z),
          hn::IfThenElse(held, q.w, hn::Set(d, 1.0F))};
}

HWY_INLINE Quaternions<Floats> sampled_rotations(const SamplePoint& point, const SampledPacket& packet, int bone) {
  const Quaternions<Floats> q = weighed_rotations(point, packet, bone);
  return with_identity_behind(packet, bone, scaled(q, factor_to_unit(packet, q)));
}

/// The encoding of positions or scales of a packet: base + step * weighed value, quad by quad.
struct SampledRanges {
  const SampledPacket& packet;
  const std::int32_t* offsets;
  const std::int32_t* ranges;
};
HWY_INLINE SampledRanges positions_of(const SampledPacket& packet) {
  return {packet, packet.position_offset, packet.position_range};
}
HWY_INLINE SampledRanges scales_of(const SampledPacket& packet) {
  return {packet, packet.scale_offset, packet.scale_range};
}

/// The lanes of a quad from `lane` on.
HWY_INLINE Floats sampled_quad(const SamplePoint& point, const SampledRanges& ranges, int quad, int lane) {
  const BoneLanes d;
  const auto& range = ranges.packet.at<QuadRange>(ranges.ranges[quad]);
  const Floats base = hn::Load(d, range.base + lane);
  const std::int32_t offset = ranges.offsets[quad];
  if (offset < 0) return base;
  const Floats weighed =
      weigh_lanes(group_words(point.from, offset), group_words(point.to, offset), lane, point.weights);
  return hn::MulAdd(weighed, hn::Load(d, range.step + lane), base);
}

/// Calls pose_quad(quad, lane) for all lanes of `quads`, one vector after the other.
template <class PoseQuad>
HWY_INLINE void for_each_quad(QuadMask quads, PoseQuad&& pose_quad) {
  for (; quads != 0; quads &= quads - 1) {
    const int quad = std::countr_zero(quads);
    for (int lane = 0; lane < 3 * quad_bones; lane += lane_count<BoneLanes>) pose_quad(quad, lane);
  }
}

HWY_INLINE void sample_quads(const SamplePoint& point, const SampledRanges& ranges, QuadMask quads, float* planes) {
  for_each_quad(quads, [&](int quad, int lane) {
    store_quad(BoneLanes(), sampled_quad(point, ranges, quad, lane), lane, planes + quad * quad_bones);
  });
}

/// Which quads of a packet are wanted.
struct Wanted {
  QuadMask positions;
  QuadMask scales;
};

HWY_INLINE void sample_packet(const SamplePoint& point, const SampledPacket& packet, Wanted wanted, float* pose) {
  const BoneLanes d;
  for (int bone = 0; bone < packet_bones; bone += lane_count<BoneLanes>) {
    store(d, sampled_rotations(point, packet, bone), pose + bone, packet_bones);
  }
  sample_quads(point, positions_of(packet), wanted.positions, pose + 4 * packet_bones);
  sample_quads(point, scales_of(packet), wanted.scales, pose + 7 * packet_bones);
}

/// The quads with scale in a packet of so many components.
HWY_INLINE QuadMask scaled_quads(int components) { return components == general_components ? all_quads : 0; }

inline void sample(const SampleJob& job) {
  assert(is_valid(job));
  const Wanted wanted{.positions = all_quads, .scales = scaled_quads(job.stream->components)};
  sample_packet(job.point, job.stream->packets()[job.packet], wanted, job.pose);
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
