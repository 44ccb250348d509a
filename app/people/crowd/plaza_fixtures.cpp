#include "app/people/crowd/plaza_fixtures.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

namespace throng::app {
namespace {

// Metres, for a person 1.8 m tall.
constexpr double least_side_with_fountain = 26.0;
constexpr double fountain_behind = 5.5;     // behind a small crowd
constexpr double beyond_edge = 1.9;         // of the rows, from the crowd's square
constexpr double slot = 3.75;               // from one thing in a row to the next
constexpr double clear_corner = 11.0;       // along the sides, from the corner where the camera stands
constexpr double clear_junction = 7.5;      // along an avenue, from its crossing with another
constexpr double bench_from_middle = 1.35;  // of an island, to the benches around it

constexpr FixtureKind row_of_things[] = {FixtureKind::tree, FixtureKind::bench, FixtureKind::tree, FixtureKind::lamp};
constexpr FixtureKind middles[] = {FixtureKind::fountain, FixtureKind::statue, FixtureKind::kiosk, FixtureKind::statue};

constexpr std::array<glm::dvec2, 4> ways{glm::dvec2(1.0, 0.0), glm::dvec2(0.0, 1.0), glm::dvec2(-1.0, 0.0),
                                         glm::dvec2(0.0, -1.0)};

// Benches around the middle, with their backs to it.
void add_benches_around(glm::dvec2 middle, double away, std::size_t count, std::size_t first,
                        std::vector<Fixture>& fixtures) {
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec2 way = ways[(first + i * ways.size() / count) % ways.size()];
    fixtures.push_back({FixtureKind::bench, middle + away * way, heading_along(way)});
  }
}

// A landmark stands where avenues meet, or in the middle of a block: it is something to walk to.
void add_landmark(FixtureKind kind, glm::dvec2 at, double spacing, std::vector<Fixture>& fixtures) {
  const glm::dvec2 to_camera = glm::normalize(glm::dvec2(1.0, 1.0));
  fixtures.push_back({kind, at, heading_along(to_camera)});
  if (kind == FixtureKind::kiosk) return;
  add_benches_around(at, (radius_of(kind) + 1.1) * spacing, kind == FixtureKind::fountain ? 4 : 2, 0, fixtures);
}

// A row between two points: trees, with benches and lamps between them. Benches look to `facing`, or in turns to both
// sides.
void add_row(glm::dvec2 from, glm::dvec2 to, glm::dvec2 facing, bool both_sides, double spacing,
             std::vector<Fixture>& fixtures) {
  const double length = glm::distance(from, to);
  const auto count = static_cast<int>(length / (slot * spacing));
  if (count < 1) return;
  const glm::dvec2 along = (to - from) / length;
  const double first = 0.5 * (length - (count - 1) * slot * spacing);
  double side = 1.0;
  for (int i = 0; i < count; ++i) {
    const FixtureKind kind = row_of_things[static_cast<std::size_t>(i) % std::size(row_of_things)];
    fixtures.push_back({kind, from + (first + i * slot * spacing) * along, heading_along(side * facing)});
    if (both_sides && kind == FixtureKind::bench) side = -side;
  }
}

void add_avenues(int blocks, double side, double spacing, std::vector<Fixture>& fixtures) {
  const double block = side / blocks, half = 0.5 * side;
  int junctions = 0;
  for (int across = 1; across < blocks; ++across) {
    const double at = across * block - half;
    for (int along = 0; along < blocks; ++along) {
      const double from = along * block - half + clear_junction * spacing;
      const double to = (along + 1) * block - half - clear_junction * spacing;
      add_row({at, from}, {at, to}, {1.0, 0.0}, true, spacing, fixtures);
      add_row({from, at}, {to, at}, {0.0, 1.0}, true, spacing, fixtures);
    }
    for (int other = 1; other < blocks; ++other) {
      const FixtureKind kind = (junctions++ + across) % 3 == 0 ? FixtureKind::statue : FixtureKind::fountain;
      add_landmark(kind, {at, other * block - half}, spacing, fixtures);
    }
  }
}

}  // namespace

void add_middle_fixtures(double side, int blocks, double spacing, std::vector<Fixture>& fixtures) {
  if (side < least_side_with_fountain * spacing) {
    const double behind = 0.5 * side + fountain_behind * spacing;
    add_landmark(FixtureKind::fountain, {-behind - 1.5 * spacing, -behind + 1.5 * spacing}, spacing, fixtures);
    return;
  }
  if (blocks == 1) {
    const double aside = 0.08 * side;
    add_landmark(FixtureKind::fountain, {-aside, aside}, spacing, fixtures);
    return;
  }
  const Square plaza{glm::dvec2(0.0), 0.5 * side};
  for (int block = 0; block < blocks * blocks; ++block) {
    const FixtureKind kind = middles[static_cast<std::size_t>(block + block / blocks) % std::size(middles)];
    add_landmark(kind, plaza.part(block, blocks).centre, spacing, fixtures);
  }
}

void add_corner_of_rest(const Square& free, double spacing, Random& random, std::vector<Fixture>& fixtures) {
  const auto jitter = [&] { return 0.2 * free.half * static_cast<double>(random.between(-1.0F, 1.0F)); };
  const glm::dvec2 at = free.centre + glm::dvec2(jitter(), jitter());
  const std::uint32_t choice = random.below(8);
  if (choice == 0) {
    fixtures.push_back({FixtureKind::kiosk, at, heading_along(ways[random.below(4)])});
    return;
  }
  fixtures.push_back({choice < 3 ? FixtureKind::planter : FixtureKind::tree, at, heading_along(ways[random.below(4)])});
  add_benches_around(at, bench_from_middle * spacing, 2, random.below(2), fixtures);
  if (random.chance(0.5F)) {
    const double away = 2.6 * spacing;
    fixtures.push_back({FixtureKind::lamp, at + away * glm::normalize(glm::dvec2(1.0, -1.0)), {}});
  }
}

void add_rows(double side, int blocks, double spacing, std::vector<Fixture>& fixtures) {
  add_avenues(blocks, side, spacing, fixtures);
  const double edge = 0.5 * side + beyond_edge * spacing;
  const double open = std::max(0.5 * side - clear_corner * spacing, -edge);
  add_row({-edge, -edge}, {-edge, edge}, ways[0], false, spacing, fixtures);
  add_row({-edge + slot * spacing, -edge}, {edge, -edge}, ways[1], false, spacing, fixtures);
  add_row({edge, -edge + slot * spacing}, {edge, open}, ways[2], false, spacing, fixtures);
  add_row({-edge + slot * spacing, edge}, {open, edge}, ways[3], false, spacing, fixtures);
}

}  // namespace throng::app
