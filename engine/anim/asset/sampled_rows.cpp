#include "engine/anim/asset/sampled_rows.h"

#include <algorithm>
#include <cassert>

namespace throng::anim {

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
