#pragma once

#include <vector>

#include "engine/anim/asset/keyframe_stream_clip.h"
#include "engine/anim/asset/root_curve.h"
#include "engine/anim/bake/surface.h"

namespace throng::anim {

/// A clip in state space, and the root motion that was taken out of it.
struct ClipInPlace {
  StateClip state;
  RootCurve root_motion;
  std::vector<Ticks> keys;  ///< times of the keys of all moving tracks, without keys that hold a travel at the ends
  double error = 0.0;       ///< metres, by which the two together may be off the file's clip on the surface
};

struct PlacingOptions {
  double start = 0.0;  ///< seconds, the file's time at time 0
  bool take_root_motion = true;
  double still = 0.0;  ///< metres, by which tracks that are held still may move the surface; 0: none is held
};

/// Brings a clip to state space, holds the tracks that hardly move, and takes its root motion out of it.
ClipInPlace put_in_place(const Skeleton& skeleton, const SurfaceProxy& proxy, const Clip& clip,
                         const PlacingOptions& options);

/// Returns the clip without a root motion that turns, as put_in_place made it, in the form of the file.
Clip without_turn(const Skeleton& skeleton, const SurfaceProxy& proxy, const Clip& clip, const RootCurve& curve,
                  double start);

}  // namespace throng::anim
