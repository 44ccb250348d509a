#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/anim/base/pose.h"
#include "engine/anim/base/units.h"

namespace throng::anim {

/// Lanes of a quad: x, y and z of four bones, then four unused lanes that fill the vector.
inline constexpr int quad_lanes = 4 * quad_bones;

/// The most steps that lie between two rows.
inline constexpr int most_steps_between_rows = 32;

/// A component of 1 as int16.
inline constexpr float quantised_one = 32767.0F;

/// The crowd's stream: one relocatable read-only block (paper 1.3), which can be loaded with one read.
///
///     SampledStream | SampledPacket x packets | constants | SampledStep x steps | row 0 | ... | last row | 64 bytes
///
/// A loop's last row repeats its first. Rows lie on an even grid of steps, but not on all of its places: a row stands
/// where the clip needs one, up to 32 steps behind the row before. Kernels load whole vectors, which at the end of the
/// last row reach into the 64 bytes behind it.
///
/// A row holds moving values as int16: the rotations of every packet with moving ones (8 bytes a bone, by whole quads),
/// then the positions of every quad with moving ones (24), then scales (24). Values that stay constant over the clip
/// are floats among the constants and take no bytes of a row. Rotations store two components side by side in groups of
/// four bones. Interleaving two rows by 16-bit lanes inside 128-bit blocks then gives the pairs of one component in
/// bone order, for every vector width. In a last packet of n quads:
///
///     qx 0-3  qy 0-3  qx 4-7  qy 4-7  ...  n times | qz 0-3  qw 0-3  ...  n times
///     px 0-3  py 0-3  pz 0-3 | ...
///
/// A rotation is int16 / quantised_one, and not unit until it is normalised. A position or scale is base + step * int16
/// / row_weight_unit, since kernels get rows already multiplied by their weights.
struct SampledPacket {
  std::int32_t lanes;                          ///< that rows store: 4, 8, 12 or 16; kernels put the identity in others
  std::int32_t rotation_offset;                ///< bytes into a row, or -1: the packet's rotations are constant
  std::int32_t rotation_constants;             ///< where rotation_offset is -1: bytes from here to float [4][16], unit
  std::int32_t position_offset[packet_quads];  ///< bytes into a row, or -1
  std::int32_t position_range[packet_quads];   ///< bytes from here to the quad's QuadRange
  std::int32_t scale_offset[packet_quads];     ///< bytes into a row, or -1
  std::int32_t scale_range[packet_quads];      ///< bytes from here to the quad's QuadRange; unused on rigid skeletons

  template <typename Value>
  const Value& at(std::int32_t bytes_from_here) const {
    return *reinterpret_cast<const Value*>(reinterpret_cast<const std::byte*>(this) + bytes_from_here);
  }
};
static_assert(sizeof(SampledPacket) == 76);

/// Positions or scales of a quad. A constant quad has only its base: other constants may follow.
struct alignas(64) QuadRange {
  float base[quad_lanes];
  float step[quad_lanes];
};
static_assert(sizeof(QuadRange) == 128);

/// Constant rotations of a packet.
struct alignas(64) PacketRotations {
  float lanes[4][packet_bones];
};

/// Says between which rows a step of the grid lies.
///
///     bit 31 ........ 10 9 ......... 5 4 ....... 0
///         row before it | steps passed | steps - 1 from that row to the next
class SampledStep {
 public:
  static constexpr int most_rows = 1 << 22;

  constexpr SampledStep(int row, int passed, int steps)
      : bits_(static_cast<std::uint32_t>(row) << 10U | static_cast<std::uint32_t>(passed) << 5U |
              static_cast<std::uint32_t>(steps - 1)) {}
  constexpr int row() const { return static_cast<int>(bits_ >> 10U); }
  constexpr std::uint32_t passed() const { return bits_ >> 5U & 31U; }
  constexpr int steps() const { return static_cast<int>(bits_ & 31U) + 1; }

 private:
  std::uint32_t bits_;
};
static_assert(sizeof(SampledStep) == 4 && most_steps_between_rows == 1 << 5);

struct alignas(64) SampledStream {
  std::uint32_t total_size;   ///< bytes, this header included
  std::uint32_t rows_offset;  ///< bytes from the start of the block, 64-byte aligned; the steps end where rows begin
  std::uint32_t row_stride;   ///< bytes, a multiple of 64
  std::int32_t row_count;
  std::int32_t step_count;  ///< from the first row to the last
  std::int32_t step_ticks;  ///< ticks of a step
  std::int32_t bone_count;
  std::int32_t components;
  Ticks first_row;
  std::uint64_t steps_per_tick;  ///< in 1/2^64, rounded up, so that no time needs a division
  Ticks duration;
  std::uint64_t displaced_quads;  ///< quads with positions other than 0; all on general skeletons; see quads_of_packet

  int packet_count() const { return packets_for(bone_count); }
  const SampledPacket* packets() const { return reinterpret_cast<const SampledPacket*>(this + 1); }
  const SampledStep* steps() const {
    return reinterpret_cast<const SampledStep*>(reinterpret_cast<const std::byte*>(this) + rows_offset) - step_count;
  }
  const std::byte* row(int index) const {
    return reinterpret_cast<const std::byte*>(this) + rows_offset + static_cast<std::size_t>(index) * row_stride;
  }
};
static_assert(sizeof(SampledStream) == 64);

/// Returns which int16 of rotations in so many stored lanes holds a component of a bone. `bone` counts inside the
/// packet.
constexpr int rotation_lane(int lanes, int component, int bone) {
  return component / 2 * 2 * lanes + bone / 4 * 8 + component % 2 * 4 + bone % 4;
}

/// Returns which lane of its quad holds a component of a position or scale.
constexpr int lane_in_quad(int component, int bone) { return component * quad_bones + bone % quad_bones; }

/// Returns the weights of two rows for a fraction from 0 to sample_fraction_one of the way between them: the weight of
/// `from` in the lower 16 bits, that of `to` in the upper. They are negative, because 32768 does not fit 16 bits and
/// -32768 does.
inline constexpr std::int32_t sample_fraction_one = 1 << 15;
inline constexpr float row_weight_unit = -1.0F / static_cast<float>(sample_fraction_one);
constexpr std::uint32_t row_weights(std::int32_t fraction) {
  return static_cast<std::uint32_t>(-fraction) << 16U |
         (static_cast<std::uint32_t>(fraction - sample_fraction_one) & 0xFFFFU);
}

/// Returns 2^32 / n, rounded up, for 1 to 32 steps between two rows.
inline constexpr auto parts_of_steps = [] {
  std::array<std::uint64_t, most_steps_between_rows + 1> parts{};
  for (std::size_t n = 1; n < parts.size(); ++n) parts[n] = ((std::uint64_t{1} << 32U) + n - 1) / n;
  return parts;
}();

/// The two rows around a time, and their weights.
struct SamplePoint {
  const std::byte* from = nullptr;
  const std::byte* to = nullptr;
  std::uint32_t weights = row_weights(0);
};
inline SamplePoint locate(const SampledStream& stream, Ticks time) {
  __extension__ using FixedPoint = unsigned __int128;  // 64 bits of whole steps, 64 of the fraction
  // A time before the first row wraps around and so lies far behind the last row.
  const std::uint64_t ticks =
      static_cast<std::uint64_t>(time.count()) - static_cast<std::uint64_t>(stream.first_row.count());
  const FixedPoint steps = static_cast<FixedPoint>(ticks) * stream.steps_per_tick;
  const auto whole = static_cast<std::uint64_t>(steps >> 64U);
  if (whole >= static_cast<std::uint64_t>(stream.step_count)) [[unlikely]] {
    const std::byte* const nearest = stream.row(time <= stream.first_row ? 0 : stream.row_count - 1);
    return {nearest, nearest, row_weights(0)};
  }
  const SampledStep step = stream.steps()[whole];
  // In half units of the fraction. 32 steps of 2^16 halves times parts of up to 2^32 fit 64 bits.
  const std::uint64_t passed =
      static_cast<std::uint64_t>(step.passed()) << 16U | static_cast<std::uint64_t>(steps) >> 48U;
  const auto halves = static_cast<std::int32_t>(passed * parts_of_steps[static_cast<std::size_t>(step.steps())] >> 32U);
  static_assert(2 * sample_fraction_one == 1 << 16);
  const std::byte* const from = stream.row(step.row());
  return {from, from + stream.row_stride, row_weights((halves + 1) / 2)};
}

}  // namespace throng::anim
