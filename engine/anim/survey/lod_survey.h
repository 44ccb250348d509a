#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "engine/anim/asset/model.h"

namespace throng::anim {

/// What levels of detail are measured on: a vertex of the surface, or the end of a bone where there is none.
struct LodPoint {
  int bone = 0;                  ///< that holds it most
  std::array<int, 4> entries{};  ///< of the palette
  std::array<double, 4> weights{};
  glm::dvec3 position{0.0};  ///< in the space of the palette
};

/// Up to 16 vertices of each bone that it holds for at least half, spread over the mesh.
std::vector<LodPoint> pick_lod_points(const Model& model);

/// Where a palette has the point.
glm::dvec3 skinned(const LodPoint& point, std::span<const glm::dmat4> palette);

/// Calls `visit` with the palettes of poses spread evenly over each clip, about 256 of them; the rest pose where there
/// is no clip.
void visit_surveyed_poses(const Model& model, const std::function<void(std::span<const glm::dmat4> palette)>& visit);

/// The value that 99 of 100 do not exceed (nearest rank); 0 of none.
float percentile_99(std::vector<float> values);

}  // namespace throng::anim
