#include "engine/anim/survey/character_bounds.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "engine/anim/asset/reference_pose.h"

namespace throng::anim {
namespace {

constexpr std::size_t most_points = 2000;
constexpr int samples_per_clip = 12;
constexpr double body_radius_of_height = 1.0 / 6.0;
constexpr double least_bounds_reach = 0.5;  // of the height: a model whose points all lie in the middle
constexpr double margin = 1.1;              // for poses between samples and vertices that were left out

double height_of(const ModelExtent& extent) {
  if (extent.top > extent.size.y / 2.0) return extent.top;
  return extent.size.y > 0.0 ? extent.size.y : std::max(extent.size.x, extent.size.z);
}

}  // namespace

BoundsSurvey::BoundsSurvey(const Model& model)
    : model_(model), points_(sample_surface(model, most_points)), extent_(measure_extent(model)) {
  if (extent_) height_ = height_of(*extent_);
}

double BoundsSurvey::reach(const Clip& clip, const glm::dvec3& travel) const {
  double reach = 0.0;
  for (int i = 0; i <= samples_per_clip; ++i) {
    const double share = static_cast<double>(i) / samples_per_clip;
    reach = std::max(reach, reach_of(&clip, clip.start + clip.length() * share, travel * share));
  }
  return reach;
}

CharacterBounds BoundsSurvey::bounds(const std::vector<double>& reaches) const {
  const double depth = extent_ ? extent_->size.z / 2.0 : 0.0;
  CharacterBounds bounds{.height = height_, .body_radius = std::max(depth, height_ * body_radius_of_height)};
  bounds.reach = reaches.empty() ? reach_of(nullptr, 0.0, glm::dvec3(0.0)) : std::ranges::max(reaches);
  bounds.reach = margin * std::max(bounds.reach, least_bounds_reach * height_);
  return bounds;
}

double BoundsSurvey::reach_of(const Clip* clip, double seconds, const glm::dvec3& root_travel) const {
  const glm::dvec3 centre = root_travel + glm::dvec3(0.0, height_ / 2.0, 0.0);
  double reach = 0.0;
  for (const glm::dvec3& place : places(points_, reference_pose(model_.skeleton, clip, seconds))) {
    const double distance = glm::distance(place, centre);
    if (std::isfinite(distance)) reach = std::max(reach, distance);
  }
  return reach;
}

}  // namespace throng::anim
