#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace throng::wardrobe {

/// Returns how far a place on or around the man's head follows an instance's face, -1 to 1: jaw (out along the normal),
/// nose (forward), brow (forward and down), eyes (apart). It depends on the place alone, so that glasses stay on noses.
glm::dvec4 face_shares(glm::dvec3 place);

}  // namespace throng::wardrobe
