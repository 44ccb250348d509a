#include "engine/anim/asset/encode_rows.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

namespace throng::anim {
namespace {

constexpr std::size_t line_bytes = 64;
constexpr std::size_t room_behind_rows = line_bytes;  // kernels load whole vectors, from the last value on too
constexpr int no_group = -1;

/// Components that are stored or left out together: rotations of a packet, positions or scales of a quad.
struct Group {
  int first_component;
  int count;
  int bones;
  bool is_rotation() const { return first_component == 0; }
};
constexpr Group rotation_group{0, 4, packet_bones};
constexpr Group position_group{4, 3, quad_bones};
constexpr Group scale_group{7, 3, quad_bones};
constexpr std::size_t rotation_bytes(int lanes) {
  return std::size_t{4} * sizeof(std::int16_t) * static_cast<std::size_t>(lanes);
}
constexpr std::size_t quad_bytes = std::size_t{3} * quad_bones * sizeof(std::int16_t);

std::size_t round_up_to_lines(std::size_t bytes) { return (bytes + line_bytes - 1) / line_bytes * line_bytes; }

/// Says whether a range is constant in the stored form: storing its middle errs no more than quantising does.
bool is_constant(const Group& group, const ComponentRange& range) {
  if (group.is_rotation()) return range.width() <= 1.0F / quantised_one;
  return range.width() <= 1e-7F + 1e-6F * std::max(std::abs(range.lowest), std::abs(range.highest));
}

bool moves(const AlignedRows& rows, int packet, const Group& group, int first_bone) {
  for (int component = group.first_component; component < group.first_component + group.count; ++component) {
    for (int lane = first_bone; lane < first_bone + group.bones; ++lane) {
      if (!is_constant(group, rows.range(packet, component, lane))) return true;
    }
  }
  return false;
}

/// Floats that lie before the rows. Equal ones share their place.
class Constants {
 public:
  /// Returns the bytes from the first constant to `values`, which are whole cache lines.
  std::size_t add(std::span<const float> values) {
    for (std::size_t at = 0; at + values.size() <= floats_.size(); at += line_bytes / sizeof(float)) {
      if (std::memcmp(&floats_[at], values.data(), values.size_bytes()) == 0) return at * sizeof(float);
    }
    const std::size_t at = floats_.size();
    floats_.insert(floats_.end(), values.begin(), values.end());
    return at * sizeof(float);
  }
  std::span<const float> floats() const { return floats_; }

 private:
  std::vector<float> floats_;
};

PacketRotations constant_rotations(const AlignedRows& rows, int packet) {
  PacketRotations rotations{};
  for (int lane = 0; lane < packet_bones; ++lane) {
    double middle[4];
    double length = 0.0;
    for (int axis = 0; axis < 4; ++axis) {
      middle[axis] = static_cast<double>(rows.range(packet, axis, lane).middle());
      length += middle[axis] * middle[axis];
    }
    length = std::sqrt(length);
    for (int axis = 0; axis < 4; ++axis) rotations.lanes[axis][lane] = static_cast<float>(middle[axis] / length);
  }
  return rotations;
}

QuadRange range_of_quad(const AlignedRows& rows, int packet, const Group& group, int quad) {
  QuadRange of_quad{};
  for (int axis = 0; axis < group.count; ++axis) {
    for (int bone = quad * quad_bones; bone < (quad + 1) * quad_bones; ++bone) {
      const ComponentRange range = rows.range(packet, group.first_component + axis, bone);
      of_quad.base[lane_in_quad(axis, bone)] = range.middle();
      of_quad.step[lane_in_quad(axis, bone)] = range.width() / (2.0F * quantised_one) * row_weight_unit;
    }
  }
  return of_quad;
}

std::int16_t quantise(float value, float base, float step) {
  if (step == 0.0F) return 0;
  const float scaled = std::round((value - base) / step);
  return static_cast<std::int16_t>(std::clamp(scaled, -quantised_one, quantised_one));
}

std::uint64_t steps_per_tick(Ticks step) {
  constexpr std::uint64_t all = std::numeric_limits<std::uint64_t>::max();
  return step > Ticks{1} ? all / static_cast<std::uint64_t>(step.count()) + 1 : all;
}

/// Lays out a stream part after part, then writes it.
class Encoder {
 public:
  explicit Encoder(const SampledRows& rows) : rows_(rows), packets_(static_cast<std::size_t>(rows_.packets())) {
    find_ranges(position_group, position_ranges_);
    if (is_general()) find_ranges(scale_group, scale_ranges_);
    place_groups();
    stride_ = round_up_to_lines(stride_);
    for (int packet = 0; packet < rows_.packets(); ++packet) describe_constants(packet);
  }

  AlignedBytes encode(Ticks duration) {
    const SampledRows& shape = rows_.shape();
    const std::vector<SampledStep> steps = steps_of_rows();
    SampledStream stream{};
    const std::size_t rows_offset =
        round_up_to_lines(constants_offset() + constants_.floats().size_bytes() + steps.size() * sizeof(SampledStep));
    stream.total_size = static_cast<std::uint32_t>(rows_offset + static_cast<std::size_t>(shape.row_count) * stride_ +
                                                   room_behind_rows);
    stream.rows_offset = static_cast<std::uint32_t>(rows_offset);
    stream.row_stride = static_cast<std::uint32_t>(stride_);
    stream.row_count = shape.row_count;
    stream.step_count = static_cast<std::int32_t>(steps.size());
    stream.step_ticks = static_cast<std::int32_t>(shape.step.count());
    stream.bone_count = shape.bone_count;
    stream.components = shape.components;
    stream.first_row = shape.first_row;
    stream.steps_per_tick = steps_per_tick(shape.step);
    stream.duration = duration;
    for (int packet = 0; packet < rows_.packets(); ++packet) {
      stream.displaced_quads |= std::uint64_t{displaced_quads(packet)} << first_quad_bit(packet);
    }

    AlignedBytes block = allocate_aligned(stream.total_size);
    const std::span<const std::byte> step_bytes = std::as_bytes(std::span(steps));
    std::memcpy(block.get(), &stream, sizeof(stream));
    std::ranges::copy(std::as_bytes(std::span(packets_)), block.get() + sizeof(stream));
    std::ranges::copy(std::as_bytes(constants_.floats()), block.get() + constants_offset());
    std::ranges::copy(step_bytes, block.get() + rows_offset - step_bytes.size());
    for (int row = 0; row < shape.row_count; ++row) {
      write_row(row, block.get() + rows_offset + static_cast<std::size_t>(row) * stride_);
    }
    return block;
  }

 private:
  bool is_general() const { return rows_.shape().components == general_components; }
  SampledPacket& header(int packet) { return packets_[static_cast<std::size_t>(packet)]; }
  std::size_t constants_offset() const {
    return round_up_to_lines(sizeof(SampledStream) + packets_.size() * sizeof(SampledPacket));
  }

  void find_ranges(const Group& group, std::vector<QuadRange>& ranges) {
    for (int quad = 0; quad < rows_.packets() * packet_quads; ++quad) {
      ranges.push_back(range_of_quad(rows_, quad / packet_quads, group, quad % packet_quads));
    }
  }
  static const QuadRange& range_in(const std::vector<QuadRange>& ranges, int packet, int quad) {
    return ranges[static_cast<std::size_t>(packet * packet_quads + quad)];
  }

  /// Rotations lie before positions, and positions before scales.
  void place_groups() {
    for (int packet = 0; packet < rows_.packets(); ++packet) {
      SampledPacket& of = header(packet);
      of.lanes = (rows_.bones_of(packet) + quad_bones - 1) / quad_bones * quad_bones;
      of.rotation_offset = place(packet, rotation_group, 0, rotation_bytes(of.lanes));
    }
    for (int packet = 0; packet < rows_.packets(); ++packet)
      place_quads(packet, position_group, header(packet).position_offset);
    for (int packet = 0; packet < rows_.packets(); ++packet) {
      if (is_general()) {
        place_quads(packet, scale_group, header(packet).scale_offset);
      } else {
        std::ranges::fill(header(packet).scale_offset, no_group);
      }
    }
  }
  void place_quads(int packet, const Group& group, std::int32_t (&offsets)[packet_quads]) {
    for (int quad = 0; quad < packet_quads; ++quad) offsets[quad] = place(packet, group, quad * quad_bones, quad_bytes);
  }
  std::int32_t place(int packet, const Group& group, int first_bone, std::size_t bytes) {
    if (!moves(rows_, packet, group, first_bone)) return no_group;
    const std::size_t at = stride_;
    stride_ += bytes;
    return static_cast<std::int32_t>(at);
  }

  void describe_constants(int packet) {
    SampledPacket& of = header(packet);
    if (of.rotation_offset == no_group) {
      const PacketRotations rotations = constant_rotations(rows_, packet);
      of.rotation_constants = add_constants(packet, {&rotations.lanes[0][0], sizeof(rotations) / sizeof(float)});
    }
    describe_ranges(packet, position_ranges_, of.position_offset, of.position_range);
    if (is_general()) describe_ranges(packet, scale_ranges_, of.scale_offset, of.scale_range);
  }
  void describe_ranges(int packet, const std::vector<QuadRange>& ranges, const std::int32_t (&offsets)[packet_quads],
                       std::int32_t (&places)[packet_quads]) {
    for (int quad = 0; quad < packet_quads; ++quad) {
      const QuadRange& range = range_in(ranges, packet, quad);
      const std::size_t bytes = offsets[quad] == no_group ? sizeof(range.base) : sizeof(range);
      places[quad] = add_constants(packet, {&range.base[0], bytes / sizeof(float)});
    }
  }
  /// Returns the bytes from the packet to the constants.
  std::int32_t add_constants(int packet, std::span<const float> values) {
    const std::size_t from_start = constants_offset() + constants_.add(values);
    return static_cast<std::int32_t>(from_start - sizeof(SampledStream) -
                                     static_cast<std::size_t>(packet) * sizeof(SampledPacket));
  }

  std::vector<SampledStep> steps_of_rows() const {
    std::vector<SampledStep> steps;
    for (int row = 0; row + 1 < rows_.shape().row_count; ++row) {
      const int gap = rows_.shape().gap_behind(row);
      for (int passed = 0; passed < gap; ++passed) steps.emplace_back(row, passed, gap);
    }
    return steps;
  }

  /// Finds the quads with displaced positions. Positions on general skeletons are no displacements, so all quads count.
  QuadMask displaced_quads(int packet) {
    if (is_general()) return all_quads;
    QuadMask quads = 0;
    for (int quad = 0; quad < packet_quads; ++quad) {
      const bool moving = header(packet).position_offset[quad] >= 0;
      const QuadRange& range = range_in(position_ranges_, packet, quad);
      const auto is_zero = [](float value) { return value == 0.0F; };
      if (moving || !std::ranges::all_of(range.base, is_zero)) quads |= QuadMask{1} << quad;
    }
    return quads;
  }

  void write_row(int row, std::byte* out) {
    for (int packet = 0; packet < rows_.packets(); ++packet) {
      if (header(packet).rotation_offset != no_group) write_rotations(row, packet, out);
      write_quads(row, packet, position_group, position_ranges_, header(packet).position_offset, out);
      if (is_general()) write_quads(row, packet, scale_group, scale_ranges_, header(packet).scale_offset, out);
    }
  }
  void write_rotations(int row, int packet, std::byte* out) {
    const SampledPacket& of = header(packet);
    std::int16_t lanes[4 * packet_bones] = {};
    for (int axis = 0; axis < 4; ++axis) {
      for (int bone = 0; bone < of.lanes; ++bone) {
        lanes[rotation_lane(of.lanes, axis, bone)] =
            quantise(rows_.value(row, packet, axis, bone), 0.0F, 1.0F / quantised_one);
      }
    }
    std::memcpy(out + of.rotation_offset, lanes, rotation_bytes(of.lanes));
  }
  void write_quads(int row, int packet, const Group& group, const std::vector<QuadRange>& ranges,
                   const std::int32_t (&offsets)[packet_quads], std::byte* out) {
    for (int quad = 0; quad < packet_quads; ++quad) {
      if (offsets[quad] == no_group) continue;
      const QuadRange& range = range_in(ranges, packet, quad);
      std::int16_t lanes[quad_lanes] = {};
      for (int axis = 0; axis < group.count; ++axis) {
        for (int bone = quad * quad_bones; bone < (quad + 1) * quad_bones; ++bone) {
          const int lane = lane_in_quad(axis, bone);
          lanes[lane] = quantise(rows_.value(row, packet, group.first_component + axis, bone), range.base[lane],
                                 range.step[lane] / row_weight_unit);
        }
      }
      std::memcpy(out + offsets[quad], lanes, quad_bytes);
    }
  }

  AlignedRows rows_;
  std::vector<QuadRange> position_ranges_, scale_ranges_;
  std::vector<SampledPacket> packets_;
  Constants constants_;
  std::size_t stride_ = 0;
};

}  // namespace

AlignedBytes encode_rows(const SampledRows& rows, Ticks duration) { return Encoder(rows).encode(duration); }

}  // namespace throng::anim
