#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "app/people/crowd/fixtures.h"
#include "app/people/crowd/layout.h"
#include "engine/base/random.h"

namespace throng::app {

/// The ground on which people form up.
struct FormationGround {
  double side;           ///< metres; the side of the square about the origin
  double spacing;        ///< CharacterRoles::spacing
  glm::dvec2 viewpoint;  ///< all people look there and keep clear of it
  std::span<const Obstacle> obstacles;
};

/// Places people in rows, as close as in a concert, a little out of line, and clear of obstacles. Rows are added past
/// the square's edge where it has no room for all.
std::vector<StanderStart> stand_in_formation(std::size_t people, const FormationGround& ground, Random random);

}  // namespace throng::app
