#include "engine/anim/asset/sampled_stream.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

namespace throng::anim {
namespace {

constexpr float quantised_one = 32767.0F;
constexpr std::size_t line_bytes = 64;
constexpr int no_group = -1;

/// Components that are stored or left out together: rotations of a packet, positions or scales of a quad.
struct Group {
  int first_component;
  int count;
  int bones;
  bool is_rotation() const { return first_component == 0; }
  /// A quad has room for four components too.
  std::size_t bytes() const { return std::size_t{4} * static_cast<std::size_t>(bones) * sizeof(std::int16_t); }
};
constexpr Group rotation_group{0, 4, packet_bones};
constexpr Group position_group{4, 3, quad_bones};
constexpr Group scale_group{7, 3, quad_bones};

struct Range {
  float lowest;
  float highest;
  float middle() const { return 0.5F * lowest + 0.5F * highest; }
  float width() const { return highest - lowest; }
};

std::size_t round_up_to_lines(std::size_t bytes) { return (bytes + line_bytes - 1) / line_bytes * line_bytes; }

/// The rows of a clip as the stream will store them: neighbouring quaternions lie on one hemisphere.
class Source {
 public:
  explicit Source(const SampledRows& rows) : shape_(rows), values_(rows.rows), packets_(packets_for(rows.bone_count)) {
    assert(values_.size() == index(rows.row_count, 0, 0, 0));
    for (int row = 1; row < rows.row_count; ++row) {
      for (int packet = 0; packet < packets_; ++packet) align_hemispheres(row, packet);
    }
  }

  int packets() const { return packets_; }
  float value(int row, int packet, int component, int lane) const {
    return values_[index(row, packet, component, lane)];
  }
  double dot_with_row_before(int row, int packet, int lane) const {
    double dot = 0.0;
    for (int axis = 0; axis < 4; ++axis) {
      dot +=
          static_cast<double>(value(row - 1, packet, axis, lane)) * static_cast<double>(value(row, packet, axis, lane));
    }
    return dot;
  }
  Range range(int packet, int component, int lane) const {
    Range range{value(0, packet, component, lane), value(0, packet, component, lane)};
    for (int row = 1; row < shape_.row_count; ++row) {
      range.lowest = std::min(range.lowest, value(row, packet, component, lane));
      range.highest = std::max(range.highest, value(row, packet, component, lane));
    }
    return range;
  }

 private:
  std::size_t index(int row, int packet, int component, int lane) const {
    const int packets_before = row * packets_ + packet;
    return (static_cast<std::size_t>(packets_before) * static_cast<std::size_t>(shape_.components) +
            static_cast<std::size_t>(component)) *
               packet_bones +
           static_cast<std::size_t>(lane);
  }
  void align_hemispheres(int row, int packet) {
    for (int lane = 0; lane < packet_bones; ++lane) {
      if (dot_with_row_before(row, packet, lane) >= 0.0) continue;
      for (int axis = 0; axis < 4; ++axis) values_[index(row, packet, axis, lane)] *= -1.0F;
    }
  }

  const SampledRows& shape_;
  std::vector<float> values_;
  int packets_;
};

/// Says whether a range is constant in the stored form: storing its middle errs no more than quantising does.
bool is_constant(const Group& group, const Range& range) {
  if (group.is_rotation()) return range.width() <= 1.0F / quantised_one;
  return range.width() <= 1e-7F + 1e-6F * std::max(std::abs(range.lowest), std::abs(range.highest));
}

bool moves(const Source& source, int packet, const Group& group, int first_bone) {
  for (int component = group.first_component; component < group.first_component + group.count; ++component) {
    for (int lane = first_bone; lane < first_bone + group.bones; ++lane) {
      if (!is_constant(group, source.range(packet, component, lane))) return true;
    }
  }
  return false;
}

/// The place in a row of each packet's or quad's moving groups.
struct RowLayout {
  std::vector<std::int32_t> rotations, positions, scales;
  std::size_t stride = 0;
};

void place(const Source& source, const Group& group, std::vector<std::int32_t>& offsets, std::size_t& end) {
  for (int packet = 0; packet < source.packets(); ++packet) {
    for (int bone = 0; bone < packet_bones; bone += group.bones) {
      const bool moving = moves(source, packet, group, bone);
      offsets.push_back(moving ? static_cast<std::int32_t>(end) : no_group);
      if (moving) end += group.bytes();
    }
  }
}

RowLayout lay_out_row(const SampledRows& rows, const Source& source) {
  RowLayout layout;
  std::size_t end = 0;
  place(source, rotation_group, layout.rotations, end);
  place(source, position_group, layout.positions, end);
  if (rows.components == general_components) {
    place(source, scale_group, layout.scales, end);
  } else {
    layout.scales.assign(layout.positions.size(), no_group);
  }
  layout.stride = round_up_to_lines(end);
  return layout;
}

std::size_t rows_offset(int packets) {
  return sizeof(SampledStream) + static_cast<std::size_t>(packets) * sizeof(SampledPacket);
}

std::size_t block_bytes(const SampledRows& rows, const RowLayout& layout) {
  return rows_offset(packets_for(rows.bone_count)) + static_cast<std::size_t>(rows.row_count) * layout.stride;
}

void write_constant_rotations(const Source& source, int packet, SampledPacket& out) {
  for (int lane = 0; lane < packet_bones; ++lane) {
    double middle[4];
    double length = 0.0;
    for (int axis = 0; axis < 4; ++axis) {
      middle[axis] = static_cast<double>(source.range(packet, axis, lane).middle());
      length += middle[axis] * middle[axis];
    }
    length = std::sqrt(length);
    for (int axis = 0; axis < 4; ++axis) out.rotation[axis][lane] = static_cast<float>(middle[axis] / length);
  }
}

void write_ranges(const Source& source, int packet, const Group& group, float (*base)[quad_lanes],
                  float (*step)[quad_lanes]) {
  for (int axis = 0; axis < group.count; ++axis) {
    for (int bone = 0; bone < packet_bones; ++bone) {
      const Range range = source.range(packet, group.first_component + axis, bone);
      base[bone / quad_bones][lane_in_quad(axis, bone)] = range.middle();
      step[bone / quad_bones][lane_in_quad(axis, bone)] = range.width() / (2.0F * quantised_one) * row_weight_unit;
    }
  }
}

/// Finds the quads with displaced positions. Positions on general skeletons are no displacements, so all quads count.
QuadMask displaced_quads(const SampledRows& rows, const SampledPacket& packet) {
  if (rows.components == general_components) return all_quads;
  QuadMask quads = 0;
  for (int quad = 0; quad < packet_quads; ++quad) {
    const auto is_zero = [](float value) { return value == 0.0F; };
    if (packet.position_offset[quad] >= 0 || !std::ranges::all_of(packet.position_base[quad], is_zero)) {
      quads |= QuadMask{1} << quad;
    }
  }
  return quads;
}

SampledPacket describe_packet(const SampledRows& rows, const Source& source, const RowLayout& layout, int packet) {
  SampledPacket out{};
  out.rotation_offset = layout.rotations[static_cast<std::size_t>(packet)];
  std::copy_n(layout.positions.begin() + packet * packet_quads, packet_quads, out.position_offset);
  std::copy_n(layout.scales.begin() + packet * packet_quads, packet_quads, out.scale_offset);
  write_constant_rotations(source, packet, out);
  write_ranges(source, packet, position_group, out.position_base, out.position_step);
  for (auto& quad : out.scale_base) std::fill_n(quad, 3 * quad_bones, 1.0F);
  if (rows.components == general_components) {
    write_ranges(source, packet, scale_group, out.scale_base, out.scale_step);
  }
  return out;
}

std::int16_t quantise(float value, float base, float step) {
  if (step == 0.0F) return 0;
  const float scaled = std::round((value - base) / step);
  return static_cast<std::int16_t>(std::clamp(scaled, -quantised_one, quantised_one));
}

void write_rotations(const Source& source, int row, int packet, std::byte* out) {
  std::int16_t lanes[4 * packet_bones];
  for (int axis = 0; axis < 4; ++axis) {
    for (int bone = 0; bone < packet_bones; ++bone) {
      lanes[rotation_lane(axis, bone)] = quantise(source.value(row, packet, axis, bone), 0.0F, 1.0F / quantised_one);
    }
  }
  std::memcpy(out, lanes, sizeof(lanes));
}

void write_quads(const Source& source, int row, int packet, const Group& group,
                 const std::int32_t (&offsets)[packet_quads], const float (*base)[quad_lanes],
                 const float (*step)[quad_lanes], std::byte* out) {
  for (int quad = 0; quad < packet_quads; ++quad) {
    if (offsets[quad] < 0) continue;
    std::int16_t lanes[quad_lanes] = {};
    for (int axis = 0; axis < group.count; ++axis) {
      for (int bone = quad * quad_bones; bone < (quad + 1) * quad_bones; ++bone) {
        const int lane = lane_in_quad(axis, bone);
        lanes[lane] = quantise(source.value(row, packet, group.first_component + axis, bone), base[quad][lane],
                               step[quad][lane] / row_weight_unit);
      }
    }
    std::memcpy(out + offsets[quad], lanes, sizeof(lanes));
  }
}

void write_row(const Source& source, int row, std::span<const SampledPacket> packets, std::byte* out) {
  for (int packet = 0; packet < source.packets(); ++packet) {
    const SampledPacket& header = packets[static_cast<std::size_t>(packet)];
    if (header.rotation_offset >= 0) write_rotations(source, row, packet, out + header.rotation_offset);
    write_quads(source, row, packet, position_group, header.position_offset, header.position_base, header.position_step,
                out);
    write_quads(source, row, packet, scale_group, header.scale_offset, header.scale_base, header.scale_step, out);
  }
}

std::uint64_t rows_per_tick(Ticks row_step) {
  constexpr std::uint64_t all = std::numeric_limits<std::uint64_t>::max();
  return row_step > Ticks{1} ? all / static_cast<std::uint64_t>(row_step.count()) + 1 : all;
}

}  // namespace

bool turns_too_far(const SampledRows& rows) {
  const Source source(rows);
  for (int row = 1; row < rows.row_count; ++row) {
    for (int packet = 0; packet < source.packets(); ++packet) {
      for (int lane = 0; lane < packet_bones; ++lane) {
        if (source.dot_with_row_before(row, packet, lane) < least_row_dot) return true;
      }
    }
  }
  return false;
}

std::size_t sampled_stream_bytes(const SampledRows& rows) { return block_bytes(rows, lay_out_row(rows, Source(rows))); }

void encode_sampled_stream(const SampledRows& rows, Ticks duration, std::span<std::byte> block) {
  const Source source(rows);
  const RowLayout layout = lay_out_row(rows, source);
  assert(block.size() == block_bytes(rows, layout));
  assert(reinterpret_cast<std::uintptr_t>(block.data()) % line_bytes == 0);
  std::memset(block.data(), 0, block.size());

  SampledStream stream{};
  stream.total_size = static_cast<std::uint32_t>(block.size());
  stream.rows_offset = static_cast<std::uint32_t>(rows_offset(source.packets()));
  stream.row_stride = static_cast<std::uint32_t>(layout.stride);
  stream.row_count = rows.row_count;
  stream.bone_count = rows.bone_count;
  stream.components = rows.components;
  stream.first_row = rows.first_row;
  stream.row_step = rows.row_step;
  stream.rows_per_tick = rows_per_tick(rows.row_step);
  stream.duration = duration;

  std::vector<SampledPacket> packets;
  packets.reserve(static_cast<std::size_t>(source.packets()));
  for (int packet = 0; packet < source.packets(); ++packet) {
    packets.push_back(describe_packet(rows, source, layout, packet));
    stream.displaced_quads |= std::uint64_t{displaced_quads(rows, packets.back())} << first_quad_bit(packet);
  }
  std::memcpy(block.data(), &stream, sizeof(stream));
  std::memcpy(block.data() + sizeof(stream), packets.data(), packets.size() * sizeof(SampledPacket));
  for (int row = 0; row < rows.row_count; ++row) {
    write_row(source, row, packets, block.data() + stream.rows_offset + static_cast<std::size_t>(row) * layout.stride);
  }
}

}  // namespace throng::anim
