#include "app/crowd/layout.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include <glm/common.hpp>

#include "app/crowd/groups.h"
#include "app/crowd/random.h"

namespace throng::app {
namespace {

// Metres, for a person 1.8 m tall.
constexpr double area_per_agent = 3.6;
constexpr double promenade_block = 60.0;  // a larger plaza is cut into blocks of about this side
constexpr double smallest_block_with_loops = 26.0;
constexpr double loop_cell = 15.0;
constexpr double lane_pitch = 1.1;
constexpr double least_gap_in_lane = 1.1;
constexpr double clear_of_lane = 0.9;

constexpr double share_of_walkers = 0.4;
constexpr float share_of_cells_with_loop = 0.65F;

// Speed of a lane relative to the walk clip: with heights of 0.9 to 1.08, everyone's playback stays within 0.9 to 1.1.
constexpr float slowest_lane = 0.94F, fastest_lane = 1.03F;

struct Square {
  glm::dvec2 centre;
  double half;

  /// One of `rows` times `rows` squares that this one is cut into.
  Square part(int index, int rows) const {
    const double half_part = half / rows;
    return {centre + half_part * glm::dvec2(2 * (index % rows) + 1 - rows, 2 * (index / rows) + 1 - rows), half_part};
  }
};

/// Lays lanes, and remembers the ground that they take from those who stand.
class LanePlanner {
 public:
  LanePlanner(std::uint32_t seed, const CharacterRoles& roles)
      : random_(seed, 1), spacing_(roles.spacing()), walk_speed_(roles.walk_speed) {}

  void lay_block(const Square& block);

  std::vector<Lane> lanes;
  std::vector<LaneGround> ground;

 private:
  void lay_band(glm::dvec2 centre, glm::dvec2 half_extents, double corner_radius, int count);
  void lay_loops(const Square& inside);

  Random random_;
  double spacing_;
  double walk_speed_;
};

// `count` lanes side by side, the outermost first, walked in turns one way and the other.
void LanePlanner::lay_band(glm::dvec2 centre, glm::dvec2 half_extents, double corner_radius, int count) {
  const double pitch = lane_pitch * spacing_;
  const double innermost = std::max(corner_radius - (count - 1) * pitch, 0.7 * spacing_);
  const glm::dvec2 core = glm::max(half_extents - glm::dvec2(innermost + (count - 1) * pitch), glm::dvec2(0.0));
  double direction = random_.chance(0.5F) ? 1.0 : -1.0;
  for (int lane = count - 1; lane >= 0; --lane, direction = -direction) {
    const double speed = walk_speed_ * static_cast<double>(random_.between(slowest_lane, fastest_lane));
    lanes.push_back({centre, core, innermost + lane * pitch, direction, speed});
  }
  ground.push_back(
      {lanes[lanes.size() - static_cast<std::size_t>(count)], (count - 1) * pitch, clear_of_lane * spacing_});
}

void LanePlanner::lay_loops(const Square& inside) {
  const int cells = std::max(1, static_cast<int>(std::lround(2.0 * inside.half / (loop_cell * spacing_))));
  for (int index = 0; index < cells * cells; ++index) {
    const Square cell = inside.part(index, cells);
    if (!random_.chance(share_of_cells_with_loop)) continue;
    const glm::dvec2 half_extents =
        (cell.half - spacing_) * glm::dvec2(static_cast<double>(random_.between(0.55F, 0.95F)),
                                            static_cast<double>(random_.between(0.55F, 0.95F)));
    const double radius = std::min(half_extents.x, half_extents.y) * static_cast<double>(random_.between(0.6F, 1.0F));
    lay_band(cell.centre, half_extents, radius, 1 + static_cast<int>(random_.below(2)));
  }
}

// A promenade along the block's edge and, where there is room, small loops inside.
void LanePlanner::lay_block(const Square& block) {
  const bool large = 2.0 * block.half >= smallest_block_with_loops * spacing_;
  const double inset = std::min(static_cast<double>(random_.between(2.3F, 3.3F)) * spacing_, 0.4 * block.half);
  const double half = block.half - inset;
  const int count = half > 5.0 * spacing_ ? 3 : (half > 3.0 * spacing_ ? 2 : 1);
  const auto roundness = static_cast<double>(large ? random_.between(0.28F, 0.45F) : random_.between(0.75F, 1.0F));
  lay_band(block.centre, glm::dvec2(half), roundness * half, count);
  if (large) lay_loops({block.centre, half - ((count - 1) * lane_pitch + 1.5) * spacing_});
}

void lay_blocks(double side, double spacing, LanePlanner& planner) {
  const int blocks = std::max(1, static_cast<int>(std::lround(side / (promenade_block * spacing))));
  const Square plaza{glm::dvec2(0.0), 0.5 * side};
  for (int block = 0; block < blocks * blocks; ++block) planner.lay_block(plaza.part(block, blocks));
}

// Walkers at even distances, give or take what keeps them `least_gap` apart.
void fill_lane(std::uint32_t index, double length, std::size_t count, double least_gap, Random& random,
               std::vector<WalkerStart>& walkers) {
  const double step = length / static_cast<double>(count);
  const double first = static_cast<double>(random.unit()) * length;
  for (std::size_t walker = 0; walker < count; ++walker) {
    const double jitter = static_cast<double>(random.between(-0.5F, 0.5F)) * (step - least_gap);
    walkers.push_back({index, std::fmod(first + static_cast<double>(walker) * step + jitter + length, length)});
  }
}

// Shares walkers out by length; what the lanes cannot hold is left over.
std::vector<WalkerStart> fill_lanes(std::span<const Lane> lanes, std::size_t wanted, double least_gap, Random random) {
  double total = 0.0;
  for (const Lane& lane : lanes) total += lane.length();
  std::vector<WalkerStart> walkers;
  walkers.reserve(wanted);
  double passed = 0.0;
  for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
    const double length = lanes[lane].length();
    passed += length;
    const bool last = lane + 1 == lanes.size();
    const auto until = last ? wanted : static_cast<std::size_t>(passed / total * static_cast<double>(wanted));
    const auto room = static_cast<std::size_t>(length / least_gap);
    const std::size_t count = std::min(until - std::min(until, walkers.size()), room);
    if (count > 0) fill_lane(static_cast<std::uint32_t>(lane), length, count, least_gap, random, walkers);
  }
  return walkers;
}

}  // namespace

double plaza_side(std::size_t agents, double spacing) {
  return std::sqrt(area_per_agent * static_cast<double>(agents)) * spacing;
}

glm::dvec2 plaza_viewpoint(std::size_t agents, double spacing) {
  const double from_centre = std::max(plaza_side(agents, spacing) / std::numbers::sqrt2, 5.5 * spacing);
  return glm::dvec2(from_centre / std::numbers::sqrt2);
}

CrowdLayout plaza_layout(std::size_t agents, std::uint32_t seed, const CharacterRoles& roles) {
  const double spacing = roles.spacing();
  const double side = plaza_side(agents, spacing);
  CrowdLayout layout;
  LanePlanner planner(seed, roles);
  const auto wanted = static_cast<std::size_t>(share_of_walkers * static_cast<double>(agents));
  if (roles.can_walk() && wanted > 0) {
    lay_blocks(side, spacing, planner);
    layout.walkers = fill_lanes(planner.lanes, wanted, least_gap_in_lane * spacing, Random(seed, 2));
  }
  layout.lanes = std::move(planner.lanes);
  const GroundPlan ground{side, spacing, plaza_viewpoint(agents, spacing), planner.ground};
  layout.standers = place_groups(agents - layout.walkers.size(), ground, Random(seed, 3));
  return layout;
}

std::size_t grid_columns(std::size_t agents) {
  return static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(agents))));
}

double grid_pitch(double spacing) { return 1.5 * spacing; }

CrowdLayout grid_layout(std::size_t agents, const CharacterRoles& roles) {
  const std::size_t columns = grid_columns(agents);
  const double pitch = grid_pitch(roles.spacing());
  CrowdLayout layout;
  layout.standers.reserve(agents);
  for (std::size_t agent = 0; agent < agents; ++agent) {
    const double column = static_cast<double>(agent % columns) - 0.5 * static_cast<double>(columns - 1);
    const auto row = agent / columns;
    layout.standers.push_back({pitch * glm::dvec2(column, -static_cast<double>(row)), Heading{}});
  }
  return layout;
}

}  // namespace throng::app
