#pragma once

#include "engine/anim/run/fused/strip_poses.h"
#include "engine/anim/run/store/copy_engine.h"
#include "engine/anim/run/store/strip_palettes.h"

namespace throng::anim {

/// Poses the packets of a strip that are held: first all of them, for the entities that need bones of several packets,
/// then what these entities do, then the palettes. pose_streaming() takes the other packets afterwards.
void pose_held(const Strip& strip, const StripPoses& poses, StripPalettes& palettes, CopyEngine& engine);

/// Takes the packets of a strip that are not held from rows of clips to palettes, 16 bones of all characters at a time,
/// and lets the copy engine move a slice after each.
void pose_streaming(const Strip& strip, const StripPoses& poses, StripPalettes& palettes, CopyEngine& engine);

}  // namespace throng::anim
