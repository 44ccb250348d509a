#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/anim/base/pose.h"
#include "engine/anim/base/units.h"

namespace throng::anim {

/// The poses of a clip at a uniform rate, in state space, before they are quantised.
struct SampledRows {
  int bone_count = 0;
  int components = rigid_components;
  Ticks first_row{};        ///< time of row 0, on the clip's key grid; at most 0 unless the clip's keys start late
  Ticks row_step{};         ///< ticks between rows, > 0
  int row_count = 0;        ///< at least 1; times outside the rows show the nearest row
  std::vector<float> rows;  ///< [row][packet][component][16]; quaternions of neighbouring rows on one hemisphere
};

/// The least dot product of quaternions in neighbouring rows: they are at most 74 degrees apart. Kernels normalise the
/// values in between by a polynomial that reaches no further.
inline constexpr double least_row_dot = 0.8;
bool turns_too_far(const SampledRows& rows);

/// Lanes of a quad: x, y and z of four bones, then four unused lanes that fill the vector.
inline constexpr int quad_lanes = 4 * quad_bones;

/// The crowd's stream: one relocatable read-only block (paper 1.3), which can be loaded with one read.
///
///     SampledStream | SampledPacket x packets | row 0 | row 1 | ... | last row
///
/// A loop's last row repeats its first.
///
/// A row holds moving values as int16: the rotations of every packet with moving ones (128 bytes each), then the
/// positions of every quad with moving ones (32), then scales (32). Values that stay constant over the clip lie in the
/// packet's header and take no bytes of a row. Rotations store two components side by side in groups of four bones.
/// Interleaving two rows by 16-bit lanes inside 128-bit blocks then gives the pairs of one component in bone order, for
/// every vector width. A quad's three components are one vector, whose last four lanes are 0:
///
///     qx 0-3  qy 0-3  qx 4-7  qy 4-7  ...  qx 12-15  qy 12-15 | qz 0-3  qw 0-3 ...
///     px 0-3  py 0-3  pz 0-3  0 0 0 0 | ...
///
/// A rotation is int16 / 32767, and not unit until it is normalised. A position or scale is base + step * int16 /
/// row_weight_unit, since kernels get rows already multiplied by their weights.
struct SampledPacket {
  std::int32_t rotation_offset;                ///< bytes into a row, or -1: the packet's 16 rotations are constant
  std::int32_t position_offset[packet_quads];  ///< bytes into a row, or -1
  std::int32_t scale_offset[packet_quads];     ///< bytes into a row, or -1
  std::int32_t reserved[7];
  float rotation[4][packet_bones];  ///< used where rotation_offset is -1; unit
  float position_base[packet_quads][quad_lanes];
  float position_step[packet_quads][quad_lanes];
  float scale_base[packet_quads][quad_lanes];  ///< 1 on rigid skeletons
  float scale_step[packet_quads][quad_lanes];
};
static_assert(sizeof(SampledPacket) == 64 + 20 * 64);

struct alignas(64) SampledStream {
  std::uint32_t total_size;   ///< bytes, this header included
  std::uint32_t rows_offset;  ///< bytes from the start of the block, 64-byte aligned
  std::uint32_t row_stride;   ///< bytes, a multiple of 64
  std::int32_t row_count;
  std::int32_t bone_count;
  std::int32_t components;
  Ticks first_row;
  Ticks row_step;
  std::uint64_t rows_per_tick;  ///< in 1/2^64, rounded up, so that no time needs a division
  Ticks duration;
  std::uint64_t displaced_quads;  ///< quads with positions other than 0; all on general skeletons; see quads_of_packet

  int packet_count() const { return packets_for(bone_count); }
  const SampledPacket* packets() const { return reinterpret_cast<const SampledPacket*>(this + 1); }
  const std::byte* row(int index) const {
    return reinterpret_cast<const std::byte*>(this) + rows_offset + static_cast<std::size_t>(index) * row_stride;
  }
};
static_assert(sizeof(SampledStream) == 64);

/// Returns which int16 of a packet's rotations holds a component of a bone. `bone` counts inside the packet.
constexpr int rotation_lane(int component, int bone) {
  return component / 2 * 2 * packet_bones + bone / 4 * 8 + component % 2 * 4 + bone % 4;
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

/// The two rows around a time, and their weights.
struct SamplePoint {
  const std::byte* from = nullptr;
  const std::byte* to = nullptr;
  std::uint32_t weights = row_weights(0);
};
inline SamplePoint locate(const SampledStream& stream, Ticks time) {
  __extension__ using FixedPoint = unsigned __int128;  // 64 bits of whole rows, 64 of the fraction
  // A time before the first row wraps around and so lies far behind the last row.
  const std::uint64_t ticks =
      static_cast<std::uint64_t>(time.count()) - static_cast<std::uint64_t>(stream.first_row.count());
  const FixedPoint rows = static_cast<FixedPoint>(ticks) * stream.rows_per_tick;
  const auto whole = static_cast<std::uint64_t>(rows >> 64U);
  const int last = stream.row_count - 1;
  if (whole >= static_cast<std::uint64_t>(last)) [[unlikely]] {
    const std::byte* const nearest = stream.row(time <= stream.first_row ? 0 : last);
    return {nearest, nearest, row_weights(0)};
  }
  const auto halves = static_cast<std::int32_t>(static_cast<std::uint64_t>(rows) >> 48U);  // half units of the fraction
  static_assert(2 * sample_fraction_one == 1 << 16);
  const std::byte* const from = stream.row(static_cast<int>(whole));
  return {from, from + stream.row_stride, row_weights((halves + 1) / 2)};
}

/// Returns the size of the block for some rows, and fills it. `block` is 64-byte aligned and of that size.
std::size_t sampled_stream_bytes(const SampledRows& rows);
void encode_sampled_stream(const SampledRows& rows, Ticks duration, std::span<std::byte> block);

}  // namespace throng::anim
