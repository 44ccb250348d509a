#pragma once

#include "engine/anim/asset/sampled_stream.h"
#include "engine/anim/base/pose.h"

namespace throng::anim {

/// Sample: reads 16 bones of one character at one time. Rotations come out unit.
struct SampleJob {
  const SampledStream* stream = nullptr;
  SamplePoint point;
  int packet = 0;         ///< 0 to stream->packet_count() - 1
  float* pose = nullptr;  ///< out, [components][16]
};
bool is_valid(const SampleJob& job);

}  // namespace throng::anim
