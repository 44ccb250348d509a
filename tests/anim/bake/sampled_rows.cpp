#include "tests/anim/bake/sampled_rows.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace throng::anim::sampled_rows {
namespace {

std::size_t index_of(const SampledRows& rows, int row, int packet, int component, int lane) {
  const int packet_index = row * packets_for(rows.bone_count) + packet;
  const int component_index = packet_index * rows.components + component;
  return static_cast<std::size_t>(component_index) * packet_bones + static_cast<std::size_t>(lane);
}

SampledRows identity_rows(int bones, int components, int row_count) {
  SampledRows rows;
  rows.bone_count = bones;
  rows.components = components;
  rows.step = ticks_per_second / 30;
  rows.first_row = -rows.step / 2;
  rows.row_count = row_count;
  rows.rows.resize(index_of(rows, row_count, 0, 0, 0), 0.0F);
  for (int row = 0; row < row_count; ++row) {
    for (int packet = 0; packet < packets_for(bones); ++packet) {
      for (int lane = 0; lane < packet_bones; ++lane) {
        row_value(rows, row, packet, 3, lane) = 1.0F;
        for (int axis = 7; axis < components; ++axis) row_value(rows, row, packet, axis, lane) = 1.0F;
      }
    }
  }
  return rows;
}

void turn(SampledRows& rows, int row, int packet, int lane, double radians) {
  const double half = 0.5 * radians;
  // Crossing hemispheres now and then, as files do.
  const double sign = (row + lane) % 3 == 0 ? -1.0 : 1.0;
  row_value(rows, row, packet, lane % 3, lane) = static_cast<float>(sign * 0.6 * std::sin(half));
  row_value(rows, row, packet, (lane + 1) % 3, lane) = static_cast<float>(sign * 0.8 * std::sin(half));
  row_value(rows, row, packet, 3, lane) = static_cast<float>(sign * std::cos(half));
}

}  // namespace

float& row_value(SampledRows& rows, int row, int packet, int component, int lane) {
  return rows.rows[index_of(rows, row, packet, component, lane)];
}

float row_value(const SampledRows& rows, int row, int packet, int component, int lane) {
  return rows.rows[index_of(rows, row, packet, component, lane)];
}

SampledRows wavy_rows(int bones, int components, int row_count) {
  SampledRows rows = identity_rows(bones, components, row_count);
  for (int row = 0; row < row_count; ++row) {
    for (int bone = 0; bone < bones; ++bone) {
      const int packet = bone / packet_bones;
      const int lane = bone % packet_bones;
      const double phase = 0.3 * row + bone;
      turn(rows, row, packet, lane, 2.5 * std::sin(phase));
      if (bone % 3 != 0) continue;
      for (int component = 4; component < components; ++component) {
        row_value(rows, row, packet, component, lane) += static_cast<float>(0.7 * std::sin(phase + component));
      }
    }
  }
  return rows;
}

SampledRows still_rows(int bones, int components, int row_count) {
  SampledRows rows = identity_rows(bones, components, row_count);
  const SampledRows pose = wavy_rows(bones, components, 1);
  for (int row = 0; row < row_count; ++row) {
    std::copy(pose.rows.begin(), pose.rows.end(),
              rows.rows.begin() + row * static_cast<std::ptrdiff_t>(pose.rows.size()));
  }
  return rows;
}

StreamBlock::StreamBlock(const SampledRows& rows) : block_(encode_rows(rows, duration_of(rows))) {}

Ticks StreamBlock::duration_of(const SampledRows& rows) {
  const int steps = rows.gaps.empty() ? rows.row_count - 1 : std::accumulate(rows.gaps.begin(), rows.gaps.end(), 0);
  return steps * rows.step;
}

}  // namespace throng::anim::sampled_rows
