#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/anim/asset/sampled_stream.h"
#include "engine/anim/base/pose.h"
#include "engine/anim/base/units.h"

namespace throng::anim {

/// Poses of a clip in state space, before they are quantised. They lie on an even grid of steps.
struct SampledRows {
  int bone_count = 0;
  int components = rigid_components;
  Ticks first_row{};  ///< time of row 0, on the clip's key grid; at most 0 unless the clip's keys start late
  Ticks step{};       ///< ticks of a step, > 0
  int row_count = 0;  ///< at least 1; times outside the rows show the nearest row
  std::vector<std::uint8_t> gaps;  ///< [row_count - 1] steps from a row to the next, 1 to 32; empty: one each
  std::vector<float> rows;         ///< [row][packet][component][16]

  /// Returns the steps from a row to the next.
  int gap_behind(int row) const { return gaps.empty() ? 1 : gaps[static_cast<std::size_t>(row)]; }
  std::size_t floats_in_row() const { return pose_bytes(bone_count, components) / sizeof(float); }
};

/// The least dot product of quaternions in neighbouring rows: they are at most 74 degrees apart. Kernels normalise the
/// values in between by a polynomial that reaches no further.
inline constexpr double least_row_dot = 0.8;
bool turns_too_far(const SampledRows& rows);

/// Returns the places and times of the rows of a stream, without their values.
SampledRows places_of_rows(const SampledStream& stream);

/// Reads the rows of a stream back, as kernels read them: rotations are as long as they were rounded to.
SampledRows rows_of(const SampledStream& stream);

/// The least and the greatest that a component of a bone is in all rows.
struct ComponentRange {
  float lowest;
  float highest;
  float middle() const { return 0.5F * lowest + 0.5F * highest; }
  float width() const { return highest - lowest; }
};

/// The rows as a stream stores them: quaternions of neighbouring rows lie on one hemisphere. `rows` stay the caller's.
class AlignedRows {
 public:
  explicit AlignedRows(const SampledRows& rows);
  const SampledRows& shape() const { return shape_; }
  int packets() const { return packets_; }
  int bones_of(int packet) const;
  float value(int row, int packet, int component, int lane) const {
    return values_[index(row, packet, component, lane)];
  }
  /// Says whether a bone turns farther between two rows than least_row_dot allows.
  bool turns_too_far(int row, int other) const;
  ComponentRange range(int packet, int component, int lane) const;

 private:
  std::size_t index(int row, int packet, int component, int lane) const;
  /// Returns the dot product of a bone's quaternions in two rows.
  double dot(int row, int other, int packet, int lane) const;
  void align_hemispheres(int row, int packet);

  const SampledRows& shape_;
  std::vector<float> values_;
  int packets_;
};

}  // namespace throng::anim
