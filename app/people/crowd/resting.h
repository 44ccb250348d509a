#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "app/character/roles.h"
#include "app/people/crowd/fixtures.h"
#include "app/people/crowd/layout.h"

namespace throng::app {

/// A place where a person leans or sits: the place of the feet, and the habit.
struct RestSpot {
  glm::dvec2 position{0.0};
  Heading heading{};
  double height = 0.0;
  Habit habit = Habit::lean;
};

/// Returns the places at the trunks of trees, the closed sides of kiosks and the rims of fountains. A bench before a
/// trunk takes that side of the trunk.
std::vector<RestSpot> rest_spots(std::span<const Fixture> fixtures, double spacing);

/// Returns the flights of steps of a plaza: the middle of the lowest front, and the way that it looks.
std::vector<BenchSeat> plaza_steps(std::size_t agents, double spacing, Clothes clothes = Clothes::own);
/// Returns the places on these steps.
std::vector<RestSpot> step_places(std::span<const BenchSeat> steps, double spacing);

/// Moves some people who stand about in a plaza to its trunks, kiosks, rims and steps, as far as `roles` can lean and
/// sit there and fit the seats. No person goes where others stand.
void let_some_rest(CrowdLayout& layout, std::size_t agents, std::uint32_t seed, const CharacterRoles& roles);

}  // namespace throng::app
