#pragma once

#include <glm/gtc/quaternion.hpp>

#include "engine/anim/asset/model.h"

namespace throng::anim {

/// Turns a model as a whole about the origin of its space: roots, references, and the surfaces on the rigid path. The
/// tracks of its clips stay as they are.
void turn_model(Model& model, const glm::dquat& turn);

/// Turns a model that faces backwards by half a turn about the vertical, so that it faces +Z like any other.
void face_forward(Model& model);

}  // namespace throng::anim
