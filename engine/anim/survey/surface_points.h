#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "engine/anim/asset/model.h"
#include "engine/anim/base/transform.h"

namespace throng::anim {

inline constexpr std::size_t most_surface_points = 128;

/// What one palette entry has to do with where a point is: the sum over a point's influences of matrix * weighted is
/// the point, skinned as glTF 3.7.3.3 says.
struct PointInfluence {
  glm::vec4 weighted{0.0F};  ///< weight * (position, 1), in the space of the palette
  std::uint32_t entry = 0;   ///< of the palette
};

/// Points that stand for a character's surface where errors are measured: the farthest vertex of each bone that has
/// any, then those farthest from all before them, in the rest pose. The joints where there is no surface.
struct SurfacePoints {
  std::vector<PointInfluence> influences;  ///< point by point
  std::vector<std::uint32_t> firsts;       ///< [points + 1] of a point's influences

  std::size_t count() const { return firsts.empty() ? 0 : firsts.size() - 1; }
  std::span<const PointInfluence> of(std::size_t point) const {
    return std::span(influences).subspan(firsts[point], firsts[point + 1] - firsts[point]);
  }
};

/// `most`: 1 to most_surface_points. A character of more bones than that has only its outermost ones represented.
SurfacePoints choose_surface_points(const Model& model, std::size_t most = most_surface_points);

}  // namespace throng::anim
