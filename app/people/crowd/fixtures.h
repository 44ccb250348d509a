#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "app/people/crowd/lanes.h"
#include "app/people/crowd/steering/obstacle.h"

namespace throng::app {

/// The things that stand where a crowd walks.
enum class FixtureKind : std::uint8_t { fountain, statue, tree, planter, lamp, bench, kiosk };

struct Fixture {
  FixtureKind kind;
  glm::dvec2 position{0.0};  ///< x, z in metres
  Heading heading{};         ///< the way that its front faces
};

/// Returns the ground that fixtures take. A long fixture takes several discs. Sizes grow with `spacing`.
std::vector<Obstacle> obstacles_of(std::span<const Fixture> fixtures, double spacing);

/// Returns the radius of the largest disc that a fixture takes, in metres for a person 1.8 m tall.
double radius_of(FixtureKind kind);

/// Returns the direction on the ground that a heading looks in, and the direction to its left, which is local +X.
inline glm::dvec2 forward_of(const Heading& heading) {
  return {static_cast<double>(heading.sine), static_cast<double>(heading.cosine)};
}
inline glm::dvec2 beside(const Heading& heading) {
  return {static_cast<double>(heading.cosine), -static_cast<double>(heading.sine)};
}
/// Returns the heading that looks in a direction of length 1.
inline Heading heading_along(glm::dvec2 direction) {
  return {static_cast<float>(direction.y), static_cast<float>(direction.x)};
}

/// Returns where the fountains and statues are, x and z in metres.
std::vector<glm::dvec2> sights_of(std::span<const Fixture> fixtures);

/// Metres from the feet back to the seat, as the clip `sit` has it, for a person 1.8 m tall.
inline constexpr double seat_behind_feet = 0.39;

/// A place to sit on a bench: where the feet are.
struct BenchSeat {
  glm::dvec2 position{0.0};
  Heading heading{};
};
/// Returns the seats of all benches among the fixtures, two a bench.
std::vector<BenchSeat> bench_seats(std::span<const Fixture> fixtures, double spacing);

}  // namespace throng::app
