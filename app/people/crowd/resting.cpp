#include "app/people/crowd/resting.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/people/crowd/numbers/turn.h"
#include "app/people/crowd/plaza_plan.h"
#include "app/people/crowd/steering/cells.h"
#include "engine/base/random.h"

namespace throng::app {
namespace {

constexpr std::uint64_t resting_stream = 27;
constexpr double most_resting = 0.09;  // of people who do not walk
constexpr float chance_to_lean = 0.6F, chance_to_sit = 0.75F;

// Metres, for a person 1.8 m tall.
constexpr double back_behind_root = 0.24;  // as the clip `lean` has it
constexpr double trunk_radius = 0.13;      // of the thinnest trunk below a shoulder
constexpr double kiosk_wall = 1.39;        // from its middle, with the posts
constexpr double rim_seat = 2.80;          // from the middle of a fountain
constexpr double plinth_height = 0.18;     // around a fountain, below the feet
constexpr double heels_behind_root = 0.08;
constexpr double room_of_bench = 1.5, room_of_person = 0.57;

constexpr std::array<int, 4> rim_middles{1, 3, 5, 7};             // eighths of a turn, between the benches
constexpr std::array<double, 3> rim_offsets{-0.165, 0.0, 0.165};  // quarter turns
constexpr std::array<int, 4> closed_sides{2, 3, 5, 6};            // of the eight of a kiosk
constexpr std::array<double, 4> along_steps{-2.1, -1.3, 0.9, 1.9};

/// Returns a direction that is turned from a heading by quarter turns.
glm::dvec2 way_at(const Heading& heading, double quarters) {
  const glm::dvec2 turn = cosine_sine(quarters);
  return turn.x * forward_of(heading) + turn.y * beside(heading);
}

bool has_bench_near(std::span<const Fixture> fixtures, glm::dvec2 place, double room) {
  return std::ranges::any_of(fixtures, [&](const Fixture& fixture) {
    return fixture.kind == FixtureKind::bench && glm::distance(fixture.position, place) < room;
  });
}

RestSpot place_against(glm::dvec2 middle, glm::dvec2 out, double wall, double spacing) {
  return {.position = middle + (wall + back_behind_root) * spacing * out, .heading = heading_along(out)};
}

void add_trunk(const Fixture& tree, std::span<const Fixture> fixtures, double spacing, std::vector<RestSpot>& places) {
  for (const double quarters : {0.0, 1.0, 3.0}) {
    const RestSpot place = place_against(tree.position, way_at(tree.heading, quarters), trunk_radius, spacing);
    if (has_bench_near(fixtures, place.position, room_of_bench * spacing)) continue;
    places.push_back(place);
    return;
  }
}

void add_kiosk(const Fixture& kiosk, double spacing, std::vector<RestSpot>& places) {
  for (const int side : closed_sides) {
    places.push_back(place_against(kiosk.position, way_at(kiosk.heading, 0.5 * side), kiosk_wall, spacing));
  }
}

void add_rim(const Fixture& fountain, double spacing, std::vector<RestSpot>& places) {
  for (const int eighth : rim_middles) {
    for (const double offset : rim_offsets) {
      const glm::dvec2 out = way_at({}, 0.5 * eighth + offset);
      places.push_back({.position = fountain.position + (rim_seat + seat_behind_feet) * spacing * out,
                        .heading = heading_along(out),
                        .height = plinth_height * spacing,
                        .habit = Habit::rest});
    }
  }
}

bool can_rest(const RestSpot& place, const CharacterRoles& roles) {
  const Role role =
      place.habit == Habit::lean ? Role::lean : (place.habit == Habit::rest ? Role::sit : Role::sit_on_step);
  return roles.clip(role) != no_clip;
}

float chance_to_rest(const RestSpot& place) { return place.habit == Habit::lean ? chance_to_lean : chance_to_sit; }

/// Returns the places at which people rest: some of the places that the roles can take, in any order.
std::vector<RestSpot> chosen_places(std::vector<RestSpot> places, const CharacterRoles& roles, Random random) {
  std::erase_if(places, [&](const RestSpot& place) {
    const bool is_taken = random.chance(chance_to_rest(place));
    return !is_taken || !can_rest(place, roles);
  });
  put_in_random_order(places, random);
  return places;
}

/// Finds whether a person stands near a place while standers move to places.
class StandersNear {
 public:
  StandersNear(std::span<const StanderStart> standers, std::span<const RestSpot> places, double room)
      : room_(room), stander_count_(standers.size()) {
    for (const StanderStart& stander : standers) add(stander.position, true);
    for (const RestSpot& place : places) add(place.position, false);
    glm::vec2 lowest(0.0F), highest(0.0F);
    for (const Body& body : bodies_) {
      lowest = glm::min(lowest, body.position);
      highest = glm::max(highest, body.position);
    }
    constexpr float rounding = 0.01F;  // metres, of a position in a cell
    cells_.set_aside(bodies_.size(), lowest, highest, static_cast<float>(room) + rounding);
    cells_.sort(bodies_);
  }

  bool has_room(std::size_t place) const {
    const glm::dvec2 here = positions_[stander_count_ + place];
    bool is_free = true;
    cells_.visit_near(glm::vec2(here), [&](const Body& body) {
      is_free = is_free && !(is_taken_[body.agent] && glm::distance(positions_[body.agent], here) < room_);
    });
    return is_free;
  }
  void move(std::size_t stander, std::size_t place) {
    is_taken_[stander] = false;
    is_taken_[stander_count_ + place] = true;
  }

 private:
  void add(glm::dvec2 position, bool is_taken) {
    bodies_.push_back({.position = glm::vec2(position), .agent = static_cast<std::uint32_t>(bodies_.size())});
    positions_.push_back(position);
    is_taken_.push_back(is_taken);
  }

  double room_;  // metres
  std::size_t stander_count_;
  CrowdCells cells_;
  // [stander], then [place]
  std::vector<Body> bodies_;
  std::vector<glm::dvec2> positions_;
  std::vector<bool> is_taken_;
};

}  // namespace

std::vector<RestSpot> rest_spots(std::span<const Fixture> fixtures, double spacing) {
  std::vector<RestSpot> places;
  for (const Fixture& fixture : fixtures) {
    if (fixture.kind == FixtureKind::tree) add_trunk(fixture, fixtures, spacing, places);
    if (fixture.kind == FixtureKind::kiosk) add_kiosk(fixture, spacing, places);
    if (fixture.kind == FixtureKind::fountain) add_rim(fixture, spacing, places);
  }
  return places;
}

std::vector<BenchSeat> plaza_steps(std::size_t agents, double spacing, Clothes clothes) {
  constexpr double from_wall = 1.0, width = 6.0;
  const double front = -plaza_edge(agents, spacing, clothes) + from_wall * spacing;
  const Heading towards_crowd{.cosine = 0.0F, .sine = 1.0F};
  return {{{front, -width * spacing}, towards_crowd}, {{front, 0.0}, towards_crowd}};
}

std::vector<RestSpot> step_places(std::span<const BenchSeat> steps, double spacing) {
  std::vector<RestSpot> places;
  for (const BenchSeat& flight : steps) {
    for (const double along : along_steps) {
      const glm::dvec2 way = along * beside(flight.heading) + heels_behind_root * forward_of(flight.heading);
      places.push_back(
          {.position = flight.position + spacing * way, .heading = flight.heading, .habit = Habit::sit_low});
    }
  }
  return places;
}

void let_some_rest(CrowdLayout& layout, std::size_t agents, std::uint32_t seed, const CharacterRoles& roles) {
  if (!fits_seats(roles)) return;
  const double spacing = roles.spacing();
  std::vector<RestSpot> places = rest_spots(layout.fixtures, spacing);
  const std::vector<RestSpot> on_steps = step_places(plaza_steps(agents, spacing), spacing);
  places.insert(places.end(), on_steps.begin(), on_steps.end());
  places = chosen_places(std::move(places), roles, Random(seed, resting_stream));

  StandersNear near(layout.standers, places, room_of_person * spacing);
  // The last groups stand where the crowd is thin already.
  const auto stands = [](const StanderStart& place) { return place.habit == Habit::stand_about; };
  auto last = std::find_if_not(layout.standers.begin(), layout.standers.end(), stands);
  auto left = static_cast<std::size_t>(most_resting * static_cast<double>(layout.standers.size()));
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (left == 0 || last == layout.standers.begin()) return;
    if (!near.has_room(i)) continue;
    --left;
    --last;
    near.move(static_cast<std::size_t>(last - layout.standers.begin()), i);
    const RestSpot& place = places[i];
    *last = {.position = place.position, .heading = place.heading, .height = place.height, .habit = place.habit};
  }
}

}  // namespace throng::app
