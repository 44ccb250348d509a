#pragma once

#include <glm/vec3.hpp>

#include "assets/wardrobe/part.h"

namespace throng::wardrobe {

/// Returns where a place on or around the man's head lies on the head of another body.
glm::dvec3 head_warped(Body body, glm::dvec3 place);

}  // namespace throng::wardrobe
