#pragma once

#include <glm/vec3.hpp>

#include "assets/mannequin/cage.h"
#include "assets/wardrobe/part.h"

namespace throng::wardrobe {

/// Returns where a place on the man lies on another body. `weights` say which limb it goes with.
/// It is a smooth function of both, so that what lies on the skin stays on it.
glm::dvec3 warped(Body body, glm::dvec3 place, const mannequin::Weights& weights);

/// Weights as that body needs them: a child's eyes are too far from their joints to turn.
mannequin::Weights warped_weights(Body body, const mannequin::Weights& weights);

/// By how much the wardrobe's user draws a body smaller than the skeleton is.
double drawn_scale(Body body);

}  // namespace throng::wardrobe
