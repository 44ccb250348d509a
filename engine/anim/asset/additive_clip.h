#pragma once

#include "engine/anim/asset/clip.h"
#include "engine/anim/asset/skeleton.h"

namespace throng::anim {

/// Returns what `clip` adds to the pose that `reference` has at `seconds` of its file: a breath, a lean, a recoil. An
/// additive layer (entity/additive_layer.h) whose layer plays the result, and whose reference plays a clip without
/// tracks, which is the rest pose, adds just that to any base. Both clips are of `skeleton`.
///
/// Each bone's rotation becomes rest * inverse(reference) * clip, its translation rest + clip - reference, and its
/// scale rest * clip / reference. This is linear in the clip, so that keys keep their times, tangents and
/// interpolation. Name, times, data keys and morphs stay those of `clip`.
Clip make_additive(const Skeleton& skeleton, const Clip& clip, const Clip& reference, double seconds);

}  // namespace throng::anim
