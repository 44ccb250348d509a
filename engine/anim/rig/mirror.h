#pragma once

#include <vector>

#include "engine/anim/asset/clip.h"
#include "engine/anim/asset/skeleton.h"
#include "engine/anim/base/result.h"
#include "engine/anim/rig/rig_map.h"

namespace throng::anim {

/// Names, for each bone, the bone on the other side of the body. A bone in the middle names itself.
using MirrorMap = std::vector<int>;

/// Pairs the bones of a skeleton, left and right. Parts of the body are paired as the rig map says; other bones, such
/// as fingers, with the bone below the other parent that lies nearest to their mirror image. Errors, with the bone's
/// name: the skeleton is not rigid; the bind pose is not the mirror image of itself about the plane of the hips, x =
/// constant, to a twentieth of its extent; a bone has no partner.
Result<MirrorMap> find_mirror(const Skeleton& skeleton, const RigMap& rig);

/// Returns the clip that is to `clip` as a mirror image is: a wave of the left hand becomes one of the right. Keys keep
/// their times, tangents and interpolation. In the names of data keys, left and right change places. Morphs stay.
/// `mirror` is that of `skeleton`. A clip that is mirrored twice is itself, but for rounding.
Clip mirror_clip(const Skeleton& skeleton, const Clip& clip, const MirrorMap& mirror);

}  // namespace throng::anim
