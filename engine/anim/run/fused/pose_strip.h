#pragma once

#include "engine/anim/run/fused/strip_poses.h"
#include "engine/anim/run/store/copy_engine.h"
#include "engine/anim/run/store/strip_palettes.h"

namespace throng::anim {

/// Poses the packets of a strip that are held. It first poses all of them, then lets the entities that need bones of
/// several packets change them, then makes the palettes. pose_streaming() takes the other packets afterwards.
void pose_held(const Strip& strip, const StripPoses& poses, StripPalettes& palettes, CopyEngine& engine);

/// Takes the packets of a strip that are not held from rows of clips to palettes, 16 bones of all characters at a time,
/// and lets the copy engine move a slice after each.
void pose_streaming(const Strip& strip, const StripPoses& poses, StripPalettes& palettes, CopyEngine& engine);

}  // namespace throng::anim
