#pragma once

#include "engine/anim/run/fused/strip_poses.h"
#include "engine/anim/run/store/copy_engine.h"
#include "engine/anim/run/store/strip_palettes.h"

namespace throng::anim {

/// Poses the packets of a strip that are held: all of them first, for the entities that need bones of several packets,
/// then what these entities do, then the palettes. Its other packets are streamed afterwards.
void pose_held(const Strip& strip, const StripPoses& poses, StripPalettes& palettes, CopyEngine& engine);

}  // namespace throng::anim
