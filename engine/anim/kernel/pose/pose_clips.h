#pragma once

#include <span>

#include "engine/anim/asset/sampled_stream.h"
#include "engine/anim/base/pose.h"

namespace throng::anim {

/// Pose clips: makes one packet of characters of a strip straight from their clips, one or a blend of two. The result
/// has the bits of SampleJob and then BlendJob.
struct ClipMoment {
  const SampledStream* stream = nullptr;
  SamplePoint point;
};
struct ShownClips {
  const ClipMoment* clip = nullptr;     ///< null: the character shows no clip
  const ClipMoment* blended = nullptr;  ///< the clip that is blended onto it; or null
  float fraction = 0.0F;                ///< share of `blended`, above 0 and below 1
};
struct PoseClipsJob {
  std::span<const ShownClips> characters;  ///< at most widest_strip; characters without a clip keep their bits
  int packet = 0;
  int components = rigid_components;
  QuadMask displaced = all_quads;  ///< on rigid skeletons: positions of others are 0, neither read nor written
  float* local = nullptr;          ///< out, [character][components][16]
};
bool is_valid(const PoseClipsJob& job);

}  // namespace throng::anim
