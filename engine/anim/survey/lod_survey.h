#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "engine/anim/asset/model.h"

namespace throng::anim {

/// A point on which levels of detail are measured: a vertex of the surface, or the end of a bone where there is none.
struct LodPoint {
  int bone = 0;                  ///< the bone with the largest weight
  std::array<int, 4> entries{};  ///< palette entries
  std::array<double, 4> weights{};
  glm::dvec3 position{0.0};  ///< in the space of the palette
};

/// Picks up to 16 vertices of each bone, spread over the mesh, each of which the bone holds for at least half.
std::vector<LodPoint> pick_lod_points(const Model& model);

/// Returns the first palette entry of each bone; no_entry for a bone to which nothing is skinned.
inline constexpr int no_entry = -1;
std::vector<int> first_entries(const Skeleton& skeleton);

/// Returns where a palette puts the point.
glm::dvec3 skinned(const LodPoint& point, std::span<const glm::dmat4> palette);

/// Calls `visit` with the palettes of poses spread evenly over each clip, or of the rest pose where there is no clip.
/// A clip has 16 poses; fewer, down to 2, where there are more than 16 clips.
void visit_surveyed_poses(const Model& model, const std::function<void(std::span<const glm::dmat4> palette)>& visit);

/// Frees all keys of the clips but keys that visit_surveyed_poses reads, which then finds the same poses to the bit.
void keep_surveyed_keys(Model& model);

/// Returns the value that 99 of 100 do not exceed (nearest rank); 0 for no values.
float percentile_99(std::vector<float> values);

}  // namespace throng::anim
