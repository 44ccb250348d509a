#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "assets/mannequin/mesh.h"

namespace throng::mannequin {

inline constexpr double shape_step = 1.0 / 127;

/// The shares, -1 to 1, by which a point follows each of an instance's variations (shaders/variants.glsl says how far).
struct Shape {
  glm::dvec3 body;  ///< Out of the skin when stout, out of it when broad-shouldered, forward when stooped.
  glm::dvec2 hair;  ///< Out of the head when full, down when long; zero but on hair.
};

/// Returns a shape for each point of the skin. It is a function of the point alone, so that regions never part.
std::vector<Shape> shapes_of(const Skin& skin);

/// Returns the share by which a point follows build, frame and posture by its joints alone, without the hips, waist and
/// breasts that make one body a woman's or a man's.
glm::dvec3 shape_by_joints(const Weights& weights);

}  // namespace throng::mannequin
