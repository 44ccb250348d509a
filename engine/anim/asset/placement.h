#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "engine/anim/asset/model.h"

namespace throng::anim {

/// The way from the space of a model's file to its agent's space: metres, +Y up, the agent's feet at the origin.
/// A point p of the file is at offset + rotation * (scale * p).
struct Placement {
  double scale = 1.0;  ///< metres a unit of the file; above 0
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 offset{0.0};  ///< metres

  friend bool operator==(const Placement&, const Placement&) = default;
};

glm::dmat4 as_matrix(const Placement& placement);

/// Moves a model: everything that is posed, measured and drawn from now on is in the agent's space. Clips keep their
/// keys, because they are relative to the bones above; the roots alone change, and with them root motion.
void place_model(Model& model, const Placement& placement);

/// Turns a model that faces backwards by half a turn about the vertical, so that it faces +Z like any other. Returns
/// whether it did.
bool face_forward(Model& model);
/// Turns the models of a file, and says so in file.notes.
void face_forward(ImportedFile& file);

}  // namespace throng::anim
