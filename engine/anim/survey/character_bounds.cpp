#include "engine/anim/survey/character_bounds.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "engine/anim/asset/reference_pose.h"

namespace throng::anim {
namespace {

constexpr int samples_per_clip = 12;
constexpr double body_radius_of_height = 1.0 / 6.0;

/// A vertex that follows its strongest influence. That is near enough for a bound with a margin.
struct SurfacePoint {
  std::size_t entry;
  glm::dvec4 position;
};

std::vector<SurfacePoint> surface_points(const Model& model) {
  constexpr std::size_t most_points = 2000;
  std::size_t vertices = 0;
  for (const SkinnedMesh& mesh : model.meshes) vertices += mesh.positions.size();
  const std::size_t stride = std::max<std::size_t>(1, vertices / most_points);
  std::vector<SurfacePoint> points;
  for (const SkinnedMesh& mesh : model.meshes) {
    for (std::size_t i = 0; i < mesh.positions.size(); i += stride) {
      points.push_back({mesh.palette_entries[i].x, glm::dvec4(mesh.positions[i], 1.0)});
    }
  }
  return points;
}

std::vector<glm::dvec3> positions_in(const ReferencePose& pose, const std::vector<SurfacePoint>& points) {
  std::vector<glm::dvec3> positions;
  for (const SurfacePoint& point : points) positions.emplace_back(pose.palette[point.entry] * point.position);
  if (points.empty()) {
    for (const glm::dmat4& global : pose.globals) positions.emplace_back(global[3]);
  }
  return positions;
}

// Baking takes root motion out of clips, so the ground-plane travel of the whole body does not count.
double reach_of(const std::vector<glm::dvec3>& positions, const glm::dvec3& root_travel, double height) {
  const glm::dvec3 centre(0.0, height / 2.0, 0.0);
  double reach = 0.0;
  for (const glm::dvec3& position : positions) reach = std::max(reach, glm::distance(position - root_travel, centre));
  return reach;
}

}  // namespace

CharacterBounds measure_bounds(const Model& model) {
  const std::vector<SurfacePoint> points = surface_points(model);
  const ReferencePose rest = reference_pose(model.skeleton, nullptr, 0.0);
  CharacterBounds bounds;
  double depth = 0.0;
  for (const glm::dvec3& position : positions_in(rest, points)) {
    bounds.height = std::max(bounds.height, position.y);
    depth = std::max(depth, std::abs(position.z));
  }
  bounds.body_radius = std::max(depth, bounds.height * body_radius_of_height);
  bounds.reach = reach_of(positions_in(rest, points), glm::dvec3(0.0), bounds.height);
  for (const Clip& clip : model.clips) {
    for (int i = 0; i <= samples_per_clip; ++i) {
      const double seconds = clip.start + clip.length() * i / samples_per_clip;
      const ReferencePose pose = reference_pose(model.skeleton, &clip, seconds);
      glm::dvec3 travel = glm::dvec3(pose.globals[0][3] - rest.globals[0][3]);
      travel.y = 0.0;
      bounds.reach = std::max(bounds.reach, reach_of(positions_in(pose, points), travel, bounds.height));
    }
  }
  bounds.reach *= 1.1;  // for poses between samples and vertices that were left out
  return bounds;
}

}  // namespace throng::anim
