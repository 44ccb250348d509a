#include "app/people/crowd/fixtures.h"

#include <array>
#include <cstddef>

namespace throng::app {
namespace {

// Metres, for a person 1.8 m tall.
constexpr double bench_end = 0.6;           // from its middle to the middle of its outer discs
constexpr double bench_seat_beside = 0.42;  // from its middle to the middle of a seat
constexpr double bench_back = 0.08;         // its discs lie behind its middle, so that feet before it are free

}  // namespace

double radius_of(FixtureKind kind) {
  constexpr std::array<double, 7> radii{3.3, 1.3, 0.4, 0.8, 0.25, 0.32, 1.7};  // in the order of the kinds
  static_assert(radii.size() == static_cast<std::size_t>(FixtureKind::kiosk) + 1);
  return radii.at(static_cast<std::size_t>(kind));
}

std::vector<Obstacle> obstacles_of(std::span<const Fixture> fixtures, double spacing) {
  std::vector<Obstacle> obstacles;
  obstacles.reserve(fixtures.size());
  for (const Fixture& fixture : fixtures) {
    const double radius = radius_of(fixture.kind) * spacing;
    if (fixture.kind != FixtureKind::bench) {
      obstacles.push_back({fixture.position, radius});
      continue;
    }
    const glm::dvec2 middle = fixture.position - bench_back * spacing * forward_of(fixture.heading);
    for (const double along : {-bench_end, 0.0, bench_end}) {
      obstacles.push_back({middle + along * spacing * beside(fixture.heading), radius});
    }
  }
  return obstacles;
}

std::vector<glm::dvec2> sights_of(std::span<const Fixture> fixtures) {
  std::vector<glm::dvec2> sights;
  for (const Fixture& fixture : fixtures) {
    const bool is_sight = fixture.kind == FixtureKind::fountain || fixture.kind == FixtureKind::statue;
    if (is_sight) sights.push_back(fixture.position);
  }
  return sights;
}

std::vector<BenchSeat> bench_seats(std::span<const Fixture> fixtures, double spacing) {
  std::vector<BenchSeat> seats;
  for (const Fixture& fixture : fixtures) {
    if (fixture.kind != FixtureKind::bench) continue;
    for (const double side : {-bench_seat_beside, bench_seat_beside}) {
      const glm::dvec2 way = seat_behind_feet * forward_of(fixture.heading) + side * beside(fixture.heading);
      seats.push_back({fixture.position + spacing * way, fixture.heading});
    }
  }
  return seats;
}

}  // namespace throng::app
