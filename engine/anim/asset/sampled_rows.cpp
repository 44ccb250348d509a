#include "engine/anim/asset/sampled_rows.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace throng::anim {
namespace {

/// Reads one component of a packet after the other out of a row.
class RowReader {
 public:
  RowReader(const SampledStream& stream, int row) : stream_(stream), row_(stream.row(row)) {}

  /// Writes float [components][16]; lanes without a bone are the identity.
  void read(int packet, float* out) const {
    const SampledPacket& of = stream_.packets()[packet];
    for (int bone = 0; bone < packet_bones; ++bone) {
      for (int axis = 0; axis < 4; ++axis) out[axis * packet_bones + bone] = rotation(of, axis, bone);
      for (int axis = 0; axis < 3; ++axis) {
        out[(4 + axis) * packet_bones + bone] = in_quad(of, of.position_offset, of.position_range, axis, bone);
        if (stream_.components == rigid_components) continue;
        out[(7 + axis) * packet_bones + bone] = in_quad(of, of.scale_offset, of.scale_range, axis, bone);
      }
    }
  }

 private:
  float quantised(std::int32_t offset, int lane) const {
    std::int16_t value = 0;
    std::memcpy(&value, row_ + offset + static_cast<std::ptrdiff_t>(lane) * 2, sizeof value);
    return static_cast<float>(value);
  }
  float rotation(const SampledPacket& of, int axis, int bone) const {
    if (of.rotation_offset < 0) return of.at<PacketRotations>(of.rotation_constants).lanes[axis][bone];
    if (bone >= of.lanes) return axis == 3 ? 1.0F : 0.0F;
    return quantised(of.rotation_offset, rotation_lane(of.lanes, axis, bone)) / quantised_one;
  }
  float in_quad(const SampledPacket& of, const std::int32_t (&offsets)[packet_quads],
                const std::int32_t (&ranges)[packet_quads], int axis, int bone) const {
    const int quad = bone / quad_bones, lane = lane_in_quad(axis, bone);
    const float* const base = &of.at<float>(ranges[quad]);  // a constant quad has no steps behind it
    if (offsets[quad] < 0) return base[lane];
    return base[lane] + base[quad_lanes + lane] / row_weight_unit * quantised(offsets[quad], lane);
  }

  const SampledStream& stream_;
  const std::byte* row_;
};

}  // namespace

SampledRows places_of_rows(const SampledStream& stream) {
  SampledRows rows{.bone_count = stream.bone_count,
                   .components = stream.components,
                   .first_row = stream.first_row,
                   .step = Ticks{stream.step_ticks},
                   .row_count = stream.row_count,
                   .gaps = {},
                   .rows = {}};
  for (int step = 0; step < stream.step_count; step += rows.gaps.back()) {
    rows.gaps.push_back(static_cast<std::uint8_t>(stream.steps()[step].steps()));
  }
  return rows;
}

SampledRows rows_of(const SampledStream& stream) {
  SampledRows rows = places_of_rows(stream);
  rows.rows.resize(rows.floats_in_row() * static_cast<std::size_t>(rows.row_count));
  const std::size_t packet_floats = static_cast<std::size_t>(rows.components) * packet_bones;
  float* out = rows.rows.data();
  for (int row = 0; row < rows.row_count; ++row) {
    for (int packet = 0; packet < stream.packet_count(); ++packet, out += packet_floats) {
      RowReader(stream, row).read(packet, out);
    }
  }
  return rows;
}

AlignedRows::AlignedRows(const SampledRows& rows)
    : shape_(rows), values_(rows.rows), packets_(packets_for(rows.bone_count)) {
  assert(values_.size() == index(rows.row_count, 0, 0, 0));
  for (int row = 1; row < rows.row_count; ++row) {
    for (int packet = 0; packet < packets_; ++packet) align_hemispheres(row, packet);
  }
}

int AlignedRows::bones_of(int packet) const {
  return std::min(packet_bones, shape_.bone_count - packet * packet_bones);
}

double AlignedRows::dot(int row, int other, int packet, int lane) const {
  double dot = 0.0;
  for (int axis = 0; axis < 4; ++axis) {
    dot += static_cast<double>(value(row, packet, axis, lane)) * static_cast<double>(value(other, packet, axis, lane));
  }
  return dot;
}

bool AlignedRows::turns_too_far(int row, int other) const {
  for (int packet = 0; packet < packets_; ++packet) {
    for (int lane = 0; lane < packet_bones; ++lane) {
      if (dot(row, other, packet, lane) < least_row_dot) return true;
    }
  }
  return false;
}

ComponentRange AlignedRows::range(int packet, int component, int lane) const {
  ComponentRange range{value(0, packet, component, lane), value(0, packet, component, lane)};
  for (int row = 1; row < shape_.row_count; ++row) {
    range.lowest = std::min(range.lowest, value(row, packet, component, lane));
    range.highest = std::max(range.highest, value(row, packet, component, lane));
  }
  return range;
}

std::size_t AlignedRows::index(int row, int packet, int component, int lane) const {
  const int packets_before = row * packets_ + packet;
  return (static_cast<std::size_t>(packets_before) * static_cast<std::size_t>(shape_.components) +
          static_cast<std::size_t>(component)) *
             packet_bones +
         static_cast<std::size_t>(lane);
}

void AlignedRows::align_hemispheres(int row, int packet) {
  for (int lane = 0; lane < packet_bones; ++lane) {
    if (dot(row - 1, row, packet, lane) >= 0.0) continue;
    for (int axis = 0; axis < 4; ++axis) values_[index(row, packet, axis, lane)] *= -1.0F;
  }
}

bool turns_too_far(const SampledRows& rows) {
  const AlignedRows aligned(rows);
  for (int row = 1; row < rows.row_count; ++row) {
    if (aligned.turns_too_far(row - 1, row)) return true;
  }
  return false;
}

}  // namespace throng::anim
