#pragma once

#include "engine/anim/asset/clip.h"

namespace throng::anim {

/// Gives a clip the key that its exporter left out: every track, weight and curve comes back to the clip's first key,
/// `step` seconds after its last. The clip then repeats without a hitch, and is longer by the step.
void close_loop(Clip& clip, double step);

}  // namespace throng::anim
