#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "engine/anim/asset/model.h"
#include "engine/anim/asset/reference_pose.h"

namespace throng::anim {

inline constexpr std::size_t most_surface_points = 128;

/// The influence of one palette entry on a point. The sum of matrix * weighted over a point's influences is the point,
/// skinned as glTF 3.7.3.3 says.
struct PointInfluence {
  glm::vec4 weighted{0.0F};  ///< weight * (position, 1), in the space of the palette
  std::uint32_t entry = 0;   ///< index in the palette
};

/// Points that stand for a character's surface where errors are measured. They are the farthest vertex of each bone
/// that has any, then vertices far from all chosen before them, in the rest pose. Without a surface, they are the
/// joints.
struct SurfacePoints {
  std::vector<PointInfluence> influences;  ///< one point after the other
  std::vector<std::uint32_t> firsts;       ///< [points + 1] where a point's influences begin

  std::size_t count() const { return firsts.empty() ? 0 : firsts.size() - 1; }
  std::span<const PointInfluence> of(std::size_t point) const {
    return std::span(influences).subspan(firsts[point], firsts[point + 1] - firsts[point]);
  }
};

/// Returns about `most` vertices, and less than twice as many, evenly through all meshes, or the joints where there is
/// no surface.
SurfacePoints sample_surface(const Model& model, std::size_t most);

/// Returns the bone that moves a point most.
int main_bone(const Skeleton& skeleton, std::span<const PointInfluence> influences);

/// Returns the place of each point in a pose.
std::vector<glm::dvec3> places(const SurfacePoints& points, const ReferencePose& pose);

/// Chooses `most` points or fewer; `most` is 1 to most_surface_points. With more bones than that, only the outermost
/// ones have a point.
SurfacePoints choose_surface_points(const Model& model, std::size_t most = most_surface_points);

}  // namespace throng::anim
