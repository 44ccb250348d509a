#pragma once

#include "engine/anim/asset/encode_rows.h"

/// Rows to encode, and streams of them.
namespace throng::anim::sampled_rows {

/// Returns rows in which every bone turns and every third one moves (and scales) smoothly, at its own pace. Some
/// quaternions jump to the other hemisphere in between. The rows begin half a step before time 0.
SampledRows wavy_rows(int bones, int components, int row_count);

/// Returns rows that all have the same pose.
SampledRows still_rows(int bones, int components, int row_count);

float& row_value(SampledRows& rows, int row, int packet, int component, int lane);
float row_value(const SampledRows& rows, int row, int packet, int component, int lane);

/// An encoded stream, whose clip ends with its last row.
class StreamBlock {
 public:
  explicit StreamBlock(const SampledRows& rows);
  const SampledStream& stream() const { return *reinterpret_cast<const SampledStream*>(block_.get()); }

 private:
  static Ticks duration_of(const SampledRows& rows);
  AlignedBytes block_;
};

}  // namespace throng::anim::sampled_rows
