#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace throng::anim {

/// A local transform as glTF writes it (3.4 "Nodes"): scale first, then rotation, then translation.
struct Transform {
  glm::vec3 translation{0.0F};
  glm::quat rotation{1.0F, 0.0F, 0.0F, 0.0F};  // GLM's constructor order is w, x, y, z; memory order is x, y, z, w
  glm::vec3 scale{1.0F};
};

/// One entry of a bone palette: the top three rows of an affine matrix, row-major, 48 bytes, model space.
struct PaletteMatrix {
  float rows[3][4];
};
static_assert(sizeof(PaletteMatrix) == 48);

}  // namespace throng::anim
