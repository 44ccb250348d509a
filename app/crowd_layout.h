#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "app/crowd_lanes.h"
#include "app/crowd_roles.h"

namespace throng::app {

struct WalkerStart {
  std::uint32_t lane;
  double distance;  ///< metres from the lane's start
};

struct StanderPlace {
  glm::dvec2 position;  ///< x, z in metres
  Heading heading;
};

/// Who is where when a scene begins; walkers and standers together are all its agents.
struct CrowdLayout {
  std::vector<Lane> lanes;  ///< with their speeds
  std::vector<WalkerStart> walkers;
  std::vector<StanderPlace> standers;
};

/// Metres along one side of the square, centred on the origin, that the plaza of so many agents fills.
double plaza_side(std::size_t agents, double spacing);

/// The corner from which the plaza is looked at: x and z in metres. Nobody stands in front of it for a few metres.
glm::dvec2 plaza_viewpoint(std::size_t agents, double spacing);

/// Promenades, small loops and loose groups that fill a plaza evenly, whatever its size.
CrowdLayout plaza_layout(std::size_t agents, std::uint32_t seed, const CharacterRoles& roles);

/// Agents in a row of the grid, and metres from one to the next.
std::size_t grid_columns(std::size_t agents);
double grid_pitch(double spacing);

/// Rows that face +Z; the first is at z 0, the others behind it, x centred on 0.
CrowdLayout grid_layout(std::size_t agents, const CharacterRoles& roles);

}  // namespace throng::app
