#pragma once

#include <span>

#include "engine/anim/asset/data_keys.h"
#include "engine/anim/asset/keyframe_stream.h"
#include "engine/anim/asset/morph_curves.h"
#include "engine/anim/asset/root_curve.h"
#include "engine/anim/asset/sampled_stream.h"
#include "engine/anim/asset/user_curves.h"
#include "engine/anim/bake/stream_kind.h"

namespace throng::anim {

/// The read-only resource of one clip, in main memory (paper 2.2.2 "pointer to the animation stream"). The place of a
/// clip may be empty; no agent plays it then.
struct ClipStreams {
  const KeyframeStream* keyframe = nullptr;  ///< null: the clip plays from its sampled stream
  const SampledStream* sampled = nullptr;    ///< null: the clip plays from its keyframe stream
  Ticks duration{};
  const RootCurve* root_motion = nullptr;  ///< the motion that was taken out of the pose; null: none was
  std::span<const DataKey> data_keys{};    ///< ascending
  const UserCurves* curves = nullptr;      ///< null: the clip has none
  const MorphCurves* morphs = nullptr;     ///< null: the clip leaves the surface as it is
  double ground_speed = 0.0;               ///< metres a second (character.h); above 0 the clip is a gait

  bool is_empty() const { return keyframe == nullptr && sampled == nullptr; }
  /// Returns the stream that a player reads: the wanted one, or the only one that there is.
  StreamKind played(StreamKind wanted) const {
    if (wanted == StreamKind::sampled) return sampled != nullptr ? wanted : StreamKind::keyframe;
    return keyframe != nullptr ? wanted : StreamKind::sampled;
  }
};

}  // namespace throng::anim
