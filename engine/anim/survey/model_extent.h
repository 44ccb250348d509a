#pragma once

#include <optional>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "engine/anim/asset/model.h"

namespace throng::anim {

inline constexpr double tall_person = 1.8;  ///< metres: constants for people are meant for this height

/// The room that a model takes in its file, measured over the poses of its clips, or in its rest pose where it has no
/// clips. Units are the file's; +Y is up.
struct ModelExtent {
  glm::dvec3 size{0.0};    ///< width, height and depth: the rest pose's, unless clips show another size
  glm::dvec3 middle{0.0};  ///< of the body where clips begin: the median over clips
  double lowest = 0.0;     ///< the lowest point, of its legs where both are known: the median over poses and clips
  double top = 0.0;        ///< of a body of that size: the rest pose's, unless clips show it elsewhere
};

/// Measures a model, turned by `upright`. Returns nothing for a model without extent, all of which lies in one point.
std::optional<ModelExtent> measure_extent(const Model& model, const glm::dquat& upright = {1.0, 0.0, 0.0, 0.0});

}  // namespace throng::anim
