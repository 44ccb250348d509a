#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "engine/anim/asset/model.h"
#include "engine/anim/survey/model_extent.h"
#include "engine/anim/survey/surface_points.h"

namespace throng::anim {

/// The room that a character takes, measured over its rest pose and all its clips, without root motion.
struct CharacterBounds {
  double height = 0.0;       ///< metres, its top above the ground; its own where it is below; a person's without extent
  double body_radius = 0.0;  ///< metres, from above, arms down: half of its depth, or a sixth of its height
  double reach = 0.0;        ///< metres: no pose leaves the sphere of this radius around (0, height / 2, 0)
};

/// Measures the bounds of a model clip by clip, on any number of threads. The model must outlive it.
class BoundsSurvey {
 public:
  explicit BoundsSurvey(const Model& model);

  const std::optional<ModelExtent>& extent() const { return extent_; }

  /// Returns how far the poses of a clip reach from (0, height / 2, 0), in metres. `travel` is the root motion that
  /// baking takes out of a loop of it.
  double reach(const Clip& clip, const glm::dvec3& travel) const;

  /// Returns the bounds of a model whose clips reach so far; of its rest pose, if it has no clips.
  CharacterBounds bounds(const std::vector<double>& reaches) const;

 private:
  double reach_of(const Clip* clip, double seconds, const glm::dvec3& root_travel) const;

  const Model& model_;
  SurfacePoints points_;
  std::optional<ModelExtent> extent_;
  double height_ = tall_person;
};

}  // namespace throng::anim
