#pragma once

#include "engine/anim/asset/keyframe_stream_clip.h"
#include "engine/anim/bake/surface.h"

namespace throng::anim {

/// Makes constants of the tracks that hardly move the surface, whatever their interpolation: exporters write keys for
/// all that stands still, often STEP. A track stands at its first key then. Starts with the tracks that move least, and
/// stops before the tracks together move any point by more than `most` metres. Returns the farthest such move.
double hold_still_tracks(const Skeleton& skeleton, const SurfaceProxy& proxy, double most, StateClip& clip);

/// Returns how far the STEP tracks of a clip move the surface, in metres: the farthest of them, at most.
double largest_step(const Skeleton& skeleton, const SurfaceProxy& proxy, const StateClip& clip);

}  // namespace throng::anim
