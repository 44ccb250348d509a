#pragma once

#include "engine/anim/asset/model.h"

namespace throng::anim {

/// The room that a character takes, measured over its rest pose and all its clips, without root motion.
struct CharacterBounds {
  double height = 0.0;       ///< metres, top of the rest pose above the ground; of the joints where there is no surface
  double body_radius = 0.0;  ///< metres, from above, arms down: half of the rest pose's depth, or a sixth of its height
  double reach = 0.0;        ///< metres: no pose leaves the sphere of this radius around (0, height / 2, 0)
};

CharacterBounds measure_bounds(const Model& model);

}  // namespace throng::anim
