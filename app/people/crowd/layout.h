#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/character/roles.h"
#include "app/people/crowd/company.h"
#include "app/people/crowd/fixtures.h"
#include "app/people/crowd/habits.h"
#include "app/people/crowd/lanes.h"
#include "app/settings/settings.h"

namespace throng::app {

struct WalkerStart {
  std::uint32_t lane;
  double distance;  ///< metres from the lane's start
};

/// A place in a formation that marches along a route.
struct MarcherStart {
  double distance;  ///< metres from the route's start, along it
  double offset;    ///< metres out of the route, away from the loop's middle
  std::uint32_t company = 0;
};

/// The part that an agent at a place plays.
enum class Part : std::uint8_t { bystander, actor, prop };

struct StanderStart {
  glm::dvec2 position{0.0};  ///< x, z in metres
  Heading heading{};
  double height = 0.0;  ///< metres above the ground
  Habit habit = Habit::stand_about;
  double round = 0.0;  ///< the place along the way of a wave, 0 to below 1
  Part part = Part::bystander;
};

/// The places of all agents when a scene begins: walkers, marchers and standers.
struct CrowdLayout {
  std::vector<Lane> lanes;  ///< each with its speed
  std::vector<WalkerStart> walkers;
  Company company;
  Habit walkers_habit = Habit::stroll;
  Lane route;  ///< the marchers' route, with its speed
  std::vector<MarcherStart> marchers;
  std::vector<StanderStart> standers;
  std::vector<Fixture> fixtures;    ///< the things that stand about in a plaza
  std::vector<Obstacle> obstacles;  ///< ground that no agent walks on
  double wave_seconds = 0.0;        ///< time that a wave of cheering takes to come round; 0: there is none
  double wave_begins = 2.0;         ///< seconds
};

/// The place of each agent of a crowd, and its speed, [agent].
struct CrowdPlaces {
  std::vector<glm::vec3> positions;  ///< metres, between the feet
  std::vector<Heading> headings;
  std::vector<float> speeds;           ///< metres a second over the ground
  std::vector<float> playback_speeds;  ///< of the clip that is shown
};

/// Returns the side, in metres, of the square about the origin that the plaza of this many agents fills. Where clothes
/// form a pattern, people stand closer.
double plaza_side(std::size_t agents, double spacing, Clothes clothes = Clothes::own);

/// Returns the corner from which the camera looks at the plaza: x and z in metres. The few metres before it stay free.
glm::dvec2 plaza_viewpoint(std::size_t agents, double spacing, Clothes clothes = Clothes::own);

/// Returns whether the seats, trunks and steps of a scene, which grow with its distances, are of the character's size.
/// A character that is wide for its height, or tiny, has more distance than its height needs.
bool fits_seats(const CharacterRoles& roles);

/// Fills a plaza of any size evenly with promenades, small loops, things that stand about, and loose groups. Where
/// clothes form a pattern, all agents stand in a formation instead, and look to the viewpoint.
CrowdLayout plaza_layout(std::size_t agents, std::uint32_t seed, const CharacterRoles& roles,
                         Clothes clothes = Clothes::own);

/// Returns the number of agents in a row of the grid.
std::size_t grid_columns(std::size_t agents);
/// Returns the metres from one agent of the grid to the next.
double grid_pitch(double spacing);

/// Lays out rows that face +Z; the first is at z 0, the others behind it, x centred on 0.
CrowdLayout grid_layout(std::size_t agents, const CharacterRoles& roles);

/// Lays out people who are where a recorded crowd has them.
CrowdLayout followers_layout(std::size_t agents);

}  // namespace throng::app
