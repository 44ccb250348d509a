#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "app/character/roles.h"
#include "app/people/crowd/fixtures.h"
#include "app/people/crowd/groups.h"
#include "app/people/crowd/lanes.h"

namespace throng::app {

/// A square on the ground.
struct Square {
  glm::dvec2 centre;
  double half;  ///< metres, half its side

  /// Returns one of `rows` times `rows` squares that this one is cut into.
  Square part(int index, int rows) const {
    const double half_part = half / rows;
    return {centre + half_part * glm::dvec2(2 * (index % rows) + 1 - rows, 2 * (index / rows) + 1 - rows), half_part};
  }
};

/// The ways and things of a plaza before agents have places.
struct PlazaPlan {
  std::vector<Lane> lanes;         ///< each with its speed; none where no character can walk
  std::vector<LaneGround> ground;  ///< that the lanes take
  std::vector<Fixture> fixtures;
};
/// Nothing stands between the tower and a crowd whose clothes form a pattern.
PlazaPlan plan_plaza(std::size_t agents, std::uint32_t seed, const CharacterRoles& roles,
                     Clothes clothes = Clothes::own);

/// Returns the number of blocks in a row of the plaza. A large plaza is cut into blocks, with avenues between them; it
/// is one block where clothes form a pattern.
int plaza_blocks(double side, double spacing, Clothes clothes = Clothes::own);

/// Returns the place of the fountain that is nearest to the middle, x and z in metres.
glm::dvec2 plaza_fountain(std::size_t agents, double spacing, Clothes clothes = Clothes::own);

/// Returns half the side of the square that houses surround, in metres: a few more than the crowd takes.
double plaza_edge(std::size_t agents, double spacing, Clothes clothes = Clothes::own);

}  // namespace throng::app
