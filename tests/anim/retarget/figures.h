#pragma once

#include <string>

#include "engine/anim/asset/clip.h"
#include "engine/anim/asset/skeleton.h"

namespace throng::anim::figures {

/// The ways in which a figure differs from the person of named_skeleton.h.
struct Build {
  double legs = 1.0;        ///< length of thighs and shins
  double trunk = 1.0;       ///< length of all above the hips
  double hips = 1.0;        ///< width
  bool arms_out = false;    ///< arms are stretched to the sides in the bind pose
  bool feet_apart = false;  ///< feet hang on the root
  bool backwards = false;   ///< it faces -Z
  std::string prefix = {};  ///< before every bone's name
};

/// Returns a person of that build, whose bones have axes of their own.
Skeleton person(const Build& build = {});

/// Returns a clip of one second at 30 Hz in which a person steps on the spot and goes `metres` forward, sinks in the
/// knees at half time, and lifts the arms to the sides. Its feet stay on the ground, but for the left one's step.
Clip knee_bend(const Skeleton& skeleton, double metres = 0.0);

}  // namespace throng::anim::figures
