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

/// Where a joint is, in the space of its model.
struct JointTransform {
  float rotation[4];  ///< x y z w, unit to 1e-5
  float position[3];  ///< metres
  float scale;        ///< uniform, constant
};
static_assert(sizeof(JointTransform) == 32);

/// An affine matrix as OpenGL, glTF and GLM keep it: four columns, the last row is 0 0 0 1.
struct Matrix4x4 {
  float columns[4][4];
};
static_assert(sizeof(Matrix4x4) == 64);

}  // namespace throng::anim
