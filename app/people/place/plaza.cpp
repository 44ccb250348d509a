#include <algorithm>
#include <array>

#include "app/people/crowd/layout.h"
#include "app/people/crowd/plaza_plan.h"
#include "app/people/crowd/resting.h"
#include "app/people/place/scenes.h"

namespace throng::app {
namespace {

// Metres, for a person 1.8 m tall.
constexpr double street_corner = 8.0;  // of the sides, cut off for the street that leaves at the far corner
constexpr double street_length = 60.0;
constexpr double side_street = 9.0;
constexpr double open_corner = 26.0;  // of the sides, where the camera stands and the sun shines in
constexpr double far_street_length = 120.0;
constexpr double tower_beyond = 150.0;  // the corner
constexpr double tower_aside = 6.0;
constexpr int bollards = 6;            // across the mouth of a side street
constexpr double paved_around = 70.0;  // of the square, until fields begin

/// The prop of each kind of fixture, in the order of the kinds.
constexpr std::array<Prop, 7> fixture_props{Prop::fountain, Prop::statue, Prop::tree_a, Prop::planter,
                                            Prop::lamp,     Prop::bench,  Prop::kiosk};

void put_fixture(const Fixture& fixture, Placer& placer) {
  if (fixture.kind == FixtureKind::tree) return placer.put_tree(fixture.position);
  placer.put(fixture_props.at(static_cast<std::size_t>(fixture.kind)), fixture.position, fixture.heading);
}

// A row with a gap where a side street leaves, and houses along that street.
void put_side_with_street(glm::dvec2 from, glm::dvec2 to, glm::dvec2 facing, double gap_at, Placer& placer,
                          Placer::Houses houses) {
  const glm::dvec2 along = (to - from) / glm::distance(from, to);
  const glm::dvec2 gap = glm::mix(from, to, gap_at), half = 0.5 * side_street * placer.unit() * along;
  const glm::dvec2 back = -house_depth * placer.unit() * facing, out = -street_length * placer.unit() * facing;
  placer.put_block(from, gap - half, facing, houses);
  placer.put_block(gap + half, to, facing, houses);
  placer.put_houses(gap - half + back, gap - half + out, along, Placer::Houses::mixed);
  placer.put_houses(gap + half + back, gap + half + out, -along, Placer::Houses::mixed);
  for (int bollard = 0; bollard < bollards; ++bollard) {
    placer.put(Prop::bollard, gap + half * (2.0 * (bollard + 0.5) / bollards - 1.0), heading_along(facing));
  }
}

// A street along the diagonal, from the far corner to the tower that stands a little beside its end.
void put_far_street(double edge, Placer& placer) {
  const double unit = placer.unit(), cut = street_corner * unit;
  const glm::dvec2 away = -glm::normalize(glm::dvec2(1.0, 1.0)), across(away.y, -away.x);
  const glm::dvec2 left(-edge + cut, -edge), right(-edge, -edge + cut);
  placer.put_houses(left, left + far_street_length * unit * away, -across * glm::sign(glm::dot(left, across)),
                    Placer::Houses::mixed);
  placer.put_houses(right, right + far_street_length * unit * away, -across * glm::sign(glm::dot(right, across)),
                    Placer::Houses::mixed);
  const glm::dvec2 end = (glm::length(left + right) * 0.5 + tower_beyond * unit) * away;
  placer.put(Prop::tower, end + tower_aside * unit * across, heading_along(-away));
}

void put_steps(const SceneCrowd& crowd, Placer& placer) {
  constexpr double half_depth = 0.45;
  for (const BenchSeat& flight : plaza_steps(crowd.agents, placer.unit(), crowd.clothes)) {
    placer.put(Prop::steps, flight.position - half_depth * placer.unit() * forward_of(flight.heading), flight.heading);
  }
}

}  // namespace

render::SceneGround put_plaza(const SceneCrowd& crowd, Placer& placer) {
  const double unit = placer.unit(), edge = plaza_edge(crowd.agents, unit, crowd.clothes);
  for (const Fixture& fixture : plan_plaza(crowd.agents, crowd.seed, crowd.roles, crowd.clothes).fixtures) {
    put_fixture(fixture, placer);
  }
  const double cut = street_corner * unit;
  const double open = edge - std::max(open_corner * unit, 0.12 * edge);
  put_side_with_street({-edge, edge}, {-edge, -edge + cut}, towards_x, 0.25, placer, Placer::Houses::mixed);
  put_side_with_street({-edge + cut, -edge}, {edge, -edge}, towards_z, 0.72, placer, Placer::Houses::arcades);
  placer.put_block({edge, -edge}, {edge, open}, -towards_x, Placer::Houses::arcades);
  placer.put_block({open, edge}, {-edge, edge}, -towards_z, Placer::Houses::mixed);
  put_far_street(edge, placer);
  put_steps(crowd, placer);
  placer.put_horizon(edge);
  return {.unit = static_cast<float>(unit),
          .core = glm::vec2(static_cast<float>(edge)),
          .paved = static_cast<float>(paved_around * unit)};
}

}  // namespace throng::app
