#include "app/people/crowd/layout.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "app/people/crowd/formation.h"
#include "app/people/crowd/groups.h"
#include "app/people/crowd/plaza_plan.h"
#include "engine/base/random.h"

namespace throng::app {
namespace {

// Metres, for a person 1.8 m tall.
constexpr double area_per_agent = 3.6, area_in_formation = 1.45;
constexpr double least_gap_in_lane = 1.1;

constexpr double share_of_walkers = 0.4;  // plan_plaza() lays no lanes where that is no agent
constexpr double seats_beyond_edge = 2.5;
constexpr double room_of_seat = 0.35;
constexpr double most_seated = 0.2;    // of agents that do not walk
constexpr double least_on_seat = 0.9;  // of a scene's distances, that a body is tall

// Puts walkers at about even distances, at least `least_gap` apart.
void fill_lane(std::uint32_t index, double length, std::size_t count, double least_gap, Random& random,
               std::vector<WalkerStart>& walkers) {
  const double step = length / static_cast<double>(count);
  const double first = static_cast<double>(random.unit()) * length;
  for (std::size_t walker = 0; walker < count; ++walker) {
    const double jitter = static_cast<double>(random.between(-0.5F, 0.5F)) * (step - least_gap);
    walkers.push_back({index, std::fmod(first + static_cast<double>(walker) * step + jitter + length, length)});
  }
}

// Shares walkers out by length; walkers that the lanes cannot hold are left over.
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

// Benches that stand behind the crowd stay empty.
std::vector<BenchSeat> seats_in(double side, double spacing, std::span<const Fixture> fixtures) {
  std::vector<BenchSeat> seats = bench_seats(fixtures, spacing);
  std::erase_if(seats, [&](const BenchSeat& seat) {
    return std::max(std::abs(seat.position.x), std::abs(seat.position.y)) > 0.5 * side + seats_beyond_edge * spacing;
  });
  return seats;
}

// Some of the seats stay empty, and few people sit.
std::vector<StanderStart> seat_some(std::vector<BenchSeat> seats, std::size_t people, Random random) {
  put_in_random_order(seats, random);
  seats.resize(std::min(seats.size() * 2 / 3, static_cast<std::size_t>(most_seated * static_cast<double>(people))));
  std::vector<StanderStart> places;
  for (const BenchSeat& seat : seats) {
    places.push_back({.position = seat.position, .heading = seat.heading, .habit = Habit::rest});
  }
  return places;
}

// People who stand keep clear of the seats too.
std::vector<Obstacle> with_seats(std::vector<Obstacle> obstacles, std::span<const BenchSeat> seats, double spacing) {
  for (const BenchSeat& seat : seats) obstacles.push_back({seat.position, room_of_seat * spacing});
  return obstacles;
}

}  // namespace

double plaza_side(std::size_t agents, double spacing, Clothes clothes) {
  const auto people = static_cast<double>(agents);
  const double area =
      clothes == Clothes::pattern ? std::max(area_in_formation * people, area_per_agent) : area_per_agent * people;
  return std::sqrt(area) * spacing;
}

glm::dvec2 plaza_viewpoint(std::size_t agents, double spacing, Clothes clothes) {
  const double from_centre = std::max(plaza_side(agents, spacing, clothes) / std::numbers::sqrt2, 5.5 * spacing);
  return glm::dvec2(from_centre / std::numbers::sqrt2);
}

bool fits_seats(const CharacterRoles& roles) { return roles.size() >= least_on_seat * roles.spacing(); }

CrowdLayout plaza_layout(std::size_t agents, std::uint32_t seed, const CharacterRoles& roles, Clothes clothes) {
  const double spacing = roles.spacing();
  CrowdLayout layout;
  PlazaPlan plan = plan_plaza(agents, seed, roles, clothes);
  if (clothes == Clothes::pattern) {
    layout.obstacles = obstacles_of(plan.fixtures, spacing);
    const FormationGround ground{plaza_side(agents, spacing, clothes), spacing,
                                 plaza_viewpoint(agents, spacing, clothes), layout.obstacles};
    layout.standers = stand_in_formation(agents, ground, Random(seed, 15));
    return layout;
  }
  if (!plan.lanes.empty()) {
    const auto wanted = static_cast<std::size_t>(share_of_walkers * static_cast<double>(agents));
    layout.walkers = fill_lanes(plan.lanes, wanted, least_gap_in_lane * spacing, Random(seed, 2));
  }
  layout.lanes = std::move(plan.lanes);
  layout.obstacles = obstacles_of(plan.fixtures, spacing);
  const std::size_t left = agents - layout.walkers.size();
  const double side = plaza_side(agents, spacing);
  const std::vector<BenchSeat> seats = seats_in(side, spacing, plan.fixtures);
  const std::vector<Obstacle> taken = with_seats(layout.obstacles, seats, spacing);
  const std::vector<StanderStart> seated =
      fits_seats(roles) ? seat_some(seats, left, Random(seed, 12)) : std::vector<StanderStart>();
  const GroupGround ground{side, spacing, plaza_viewpoint(agents, spacing), plan.ground, taken};
  layout.standers = place_groups(left - seated.size(), ground, Random(seed, 3));
  layout.standers.insert(layout.standers.end(), seated.begin(), seated.end());
  layout.fixtures = std::move(plan.fixtures);
  return layout;
}

std::size_t grid_columns(std::size_t agents) {
  return static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(agents))));
}

double grid_pitch(double spacing) { return 1.5 * spacing; }

CrowdLayout followers_layout(std::size_t agents) {
  CrowdLayout layout;
  layout.standers.assign(agents, {.position = {}, .heading = {}, .habit = Habit::follow});
  return layout;
}

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
