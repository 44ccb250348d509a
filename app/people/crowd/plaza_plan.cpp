#include "app/people/crowd/plaza_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/people/crowd/layout.h"
#include "app/people/crowd/plaza_fixtures.h"
#include "engine/base/random.h"

namespace throng::app {
namespace {

// Metres, for a person 1.8 m tall.
constexpr double promenade_block = 60.0;  // a larger plaza is cut into blocks of about this side
constexpr double smallest_block_with_loops = 26.0;
constexpr double loop_cell = 15.0;
constexpr double lane_pitch = 1.1;
constexpr double clear_of_lane = 0.9;
constexpr double room_to_rest = 3.5;  // around a place where a few things stand
constexpr double from_edge = 9.0;     // of the crowd to the houses
constexpr double least_edge = 22.0;

constexpr std::size_t least_agents_with_walkers = 3;

constexpr float share_of_cells_with_loop = 0.65F;

// Speed of a lane relative to the walk clip: with heights of 0.9 to 1.08, each playback stays within 0.9 to 1.1.
constexpr float slowest_lane = 0.94F, fastest_lane = 1.03F;

std::vector<Fixture> fixtures_in(const Square& square, std::span<const Fixture> fixtures) {
  std::vector<Fixture> found;
  for (const Fixture& fixture : fixtures) {
    const glm::dvec2 from_centre = glm::abs(fixture.position - square.centre);
    if (std::max(from_centre.x, from_centre.y) < square.half) found.push_back(fixture);
  }
  return found;
}

/// Lays lanes, and keeps the ground that they take from agents that stand.
class LanePlanner {
 public:
  LanePlanner(std::uint32_t seed, const CharacterRoles& roles)
      : random_(seed, 1), spacing_(roles.spacing()), walk_speed_(roles.walk_speed) {}

  /// Lays a promenade along the edge of a block, and small loops within it where there is room.
  void lay_promenade(const Square& block);
  void lay_loops();
  /// Gives the squares that are left free, some in each block.
  std::span<const Square> free_places() const { return free_; }

  std::vector<Lane> lanes;
  std::vector<LaneGround> ground;
  std::vector<Fixture> fixtures;  // lanes keep clear of them

 private:
  /// Lanes side by side.
  struct Band {
    glm::dvec2 centre, half_extents;
    double corner_radius;
    int count;
  };
  void lay_band(const Band& band);
  void lay_loops(const Square& inside);
  std::optional<Band> loop_in(const Square& cell, std::span<const Obstacle> obstacles);
  bool is_clear(const Band& band, std::span<const Obstacle> obstacles) const;
  Lane outermost(const Band& band) const;

  Random random_;
  double spacing_;
  double walk_speed_;
  std::vector<Square> insides_;  // of promenades, with room for loops
  std::vector<Square> free_;
};

Lane LanePlanner::outermost(const Band& band) const {
  const double width = (band.count - 1) * lane_pitch * spacing_;
  const double innermost = std::max(band.corner_radius - width, 0.7 * spacing_);
  return {band.centre, glm::max(band.half_extents - glm::dvec2(innermost + width), glm::dvec2(0.0)), innermost + width};
}

// The outermost lane comes first; agents walk each lane in the opposite way of the lane before.
void LanePlanner::lay_band(const Band& band) {
  const Lane outer = outermost(band);
  double direction = random_.chance(0.5F) ? 1.0 : -1.0;
  for (int lane = 0; lane < band.count; ++lane, direction = -direction) {
    const double speed = walk_speed_ * static_cast<double>(random_.between(slowest_lane, fastest_lane));
    lanes.push_back({outer.centre, outer.core, outer.corner_radius - lane * lane_pitch * spacing_, direction, speed});
  }
  ground.push_back({lanes[lanes.size() - static_cast<std::size_t>(band.count)],
                    (band.count - 1) * lane_pitch * spacing_, clear_of_lane * spacing_});
}

bool LanePlanner::is_clear(const Band& band, std::span<const Obstacle> obstacles) const {
  const Lane outer = outermost(band);
  const double width = (band.count - 1) * lane_pitch * spacing_;
  return std::ranges::all_of(obstacles, [&](const Obstacle& obstacle) {
    const double outside = outer.signed_distance(obstacle.position), room = obstacle.radius + clear_of_lane * spacing_;
    return outside >= room || outside <= -width - room;
  });
}

std::optional<LanePlanner::Band> LanePlanner::loop_in(const Square& cell, std::span<const Obstacle> obstacles) {
  constexpr int tries = 4;
  if (!random_.chance(share_of_cells_with_loop)) return {};
  for (int i = 0; i < tries; ++i) {
    const glm::dvec2 half_extents =
        (cell.half - spacing_) * glm::dvec2(static_cast<double>(random_.between(0.55F, 0.95F)),
                                            static_cast<double>(random_.between(0.55F, 0.95F)));
    const double radius = std::min(half_extents.x, half_extents.y) * static_cast<double>(random_.between(0.6F, 1.0F));
    const Band band{cell.centre, half_extents, radius, 1 + static_cast<int>(random_.below(2))};
    if (is_clear(band, obstacles)) return band;
  }
  return {};
}

void LanePlanner::lay_loops(const Square& inside) {
  const std::vector<Obstacle> obstacles = obstacles_of(fixtures_in(inside, fixtures), spacing_);
  const int cells = std::max(1, static_cast<int>(std::lround(2.0 * inside.half / (loop_cell * spacing_))));
  for (int index = 0; index < cells * cells; ++index) {
    const Square cell = inside.part(index, cells);
    if (const auto loop = loop_in(cell, obstacles)) {
      lay_band(*loop);
    } else if (std::ranges::none_of(obstacles, [&](const Obstacle& obstacle) {
                 return glm::distance(obstacle.position, cell.centre) < obstacle.radius + room_to_rest * spacing_;
               })) {
      free_.push_back(cell);
    }
  }
}

void LanePlanner::lay_promenade(const Square& block) {
  const bool large = 2.0 * block.half >= smallest_block_with_loops * spacing_;
  const double inset = std::min(static_cast<double>(random_.between(2.3F, 3.3F)) * spacing_, 0.4 * block.half);
  const double half = block.half - inset;
  const int count = half > 5.0 * spacing_ ? 3 : (half > 3.0 * spacing_ ? 2 : 1);
  const auto roundness = static_cast<double>(large ? random_.between(0.28F, 0.45F) : random_.between(0.75F, 1.0F));
  lay_band({block.centre, glm::dvec2(half), roundness * half, count});
  if (large) insides_.push_back({block.centre, half - ((count - 1) * lane_pitch + 1.5) * spacing_});
}

void LanePlanner::lay_loops() {
  for (const Square& inside : insides_) lay_loops(inside);
}

}  // namespace

int plaza_blocks(double side, double spacing, Clothes clothes) {
  if (clothes == Clothes::pattern) return 1;
  return std::max(1, static_cast<int>(std::lround(side / (promenade_block * spacing))));
}

double plaza_edge(std::size_t agents, double spacing, Clothes clothes) {
  return std::max(0.5 * plaza_side(agents, spacing, clothes) + from_edge * spacing, least_edge * spacing);
}

glm::dvec2 plaza_fountain(std::size_t agents, double spacing, Clothes clothes) {
  std::vector<Fixture> fixtures;
  const double side = plaza_side(agents, spacing, clothes);
  add_middle_fixtures(side, plaza_blocks(side, spacing, clothes), spacing, fixtures);
  const auto distance = [](const Fixture& fixture) {
    return fixture.kind == FixtureKind::fountain ? glm::length(fixture.position) : std::numeric_limits<double>::max();
  };
  return std::ranges::min_element(fixtures, {}, distance)->position;
}

PlazaPlan plan_plaza(std::size_t agents, std::uint32_t seed, const CharacterRoles& roles, Clothes clothes) {
  const double spacing = roles.spacing(), side = plaza_side(agents, spacing, clothes);
  const int blocks = plaza_blocks(side, spacing, clothes);
  const Square plaza{glm::dvec2(0.0), 0.5 * side};
  LanePlanner planner(seed, roles);
  const bool has_walkers = roles.can_walk() && agents >= least_agents_with_walkers && clothes != Clothes::pattern;
  for (int block = 0; has_walkers && block < blocks * blocks; ++block) {
    planner.lay_promenade(plaza.part(block, blocks));
  }
  add_middle_fixtures(side, blocks, spacing, planner.fixtures);
  planner.lay_loops();
  Random random(seed, 13);
  for (const Square& free : planner.free_places()) add_corner_of_rest(free, spacing, random, planner.fixtures);
  add_rows(side, blocks, spacing, planner.fixtures);
  return {std::move(planner.lanes), std::move(planner.ground), std::move(planner.fixtures)};
}

}  // namespace throng::app
