#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "app/people/crowd/fixtures.h"
#include "app/people/crowd/layout.h"
#include "engine/base/random.h"

namespace throng::app {

/// The ground that a band of parallel lanes takes.
struct LaneGround {
  Lane outermost;
  double width;  ///< metres from the outermost lane to the innermost
  double clear;  ///< metres to keep from either
};

/// The ground on which standing agents find places.
struct GroupGround {
  double side;           ///< metres; the side of the square about the origin
  double spacing;        ///< CharacterRoles::spacing
  glm::dvec2 viewpoint;  ///< kept clear, with a few groups set before it
  std::span<const LaneGround> lanes;
  std::span<const Obstacle> obstacles;
};

/// Places loose groups of one to six, each a ring that faces its middle, at uneven distances, clear of lanes, obstacles
/// and each other.
/// Spreads past the square's edge when it is full, so all `standers` find a place.
std::vector<StanderStart> place_groups(std::size_t standers, const GroupGround& ground, Random random);

}  // namespace throng::app
