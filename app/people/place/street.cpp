#include <algorithm>
#include <array>

#include "app/people/crowd/cut_scene_layout.h"
#include "app/people/crowd/numbers/turn.h"
#include "app/people/crowd/parade.h"
#include "app/people/place/scenes.h"

namespace throng::app {
namespace {

// Metres, for a person 1.8 m tall.
constexpr double beyond_files = 0.62;  // from the outermost file to the kerb
constexpr double to_barrier = 0.8;     // from the outermost file
constexpr double barrier_pitch = 2.05;
constexpr double pavement = 4.2;       // from the last spectators to the houses
constexpr double street_paved = 75.0;  // from the last spectators until fields begin
constexpr double to_lamps = 1.6;       // from the last spectators
constexpr double lamp_pitch = 12.0;
constexpr double bunting_pitch = 14.0;
constexpr double bunting_width = 6.0;
constexpr double least_island = 0.9;  // free of people, for trees in the middle
constexpr double island_pitch = 7.5;

constexpr std::array<std::uint32_t, 5> colors{tint_of(200, 40, 44), tint_of(242, 190, 60), tint_of(38, 86, 160),
                                              tint_of(240, 238, 230), tint_of(44, 128, 92)};

std::uint32_t color_of(int turn) { return colors[static_cast<std::size_t>(turn) % colors.size()]; }

Lane beside_route(const ParadeSize& size, double away) {
  return {{0.0, 0.0}, {size.half_length, 0.0}, size.radius + away};
}

// Calls put(place, heading towards the loop's middle, number) at even distances.
void go_round(const Lane& lane, double pitch, const auto& put) {
  const auto count = static_cast<int>(lane.length() / pitch);
  for (int i = 0; i < count; ++i) {
    const LanePoint place = lane.at(lane.length() * i / count);
    put(place.position, Heading{place.heading.sine, -place.heading.cosine}, i);
  }
}

void put_barriers(const ParadeSize& size, Placer& placer) {
  const double unit = placer.unit(), away = size.half_width + to_barrier * unit;
  const auto put = [&](glm::dvec2 at, const Heading& inward, int /*number*/) { placer.put(Prop::barrier, at, inward); };
  go_round(beside_route(size, away), barrier_pitch * unit, put);
  const Lane inner = beside_route(size, -away);
  if (inner.corner_radius > unit && size.inside > size.half_width) go_round(inner, barrier_pitch * unit, put);
}

void put_flags_and_lamps(const ParadeSize& size, Placer& placer) {
  const double unit = placer.unit();
  go_round(beside_route(size, size.outside + to_lamps * unit), 0.5 * lamp_pitch * unit,
           [&](glm::dvec2 at, const Heading& inward, int number) {
             if (number % 2 == 0) return placer.put(Prop::lamp, at, inward);
             placer.put(Prop::flag, at, inward, {.tint = color_of(number / 2)});
           });
}

// Strings of bunting across both straights, from one side to the other.
void put_bunting(const ParadeSize& size, Placer& placer) {
  const double unit = placer.unit(), span = size.outside + size.half_width + 3.0 * unit;
  const auto count = std::max(1, static_cast<int>(2.0 * size.half_length / (bunting_pitch * unit)));
  for (int i = 0; i < count; ++i) {
    const double x = size.half_length * (2.0 * (i + 0.5) / count - 1.0);
    for (const double side : {-1.0, 1.0}) {
      const double middle = side * (size.radius + 0.5 * (size.outside - size.half_width));
      placer.put(Prop::bunting, {x, middle}, heading_along(towards_x),
                 {.stretch = {span / (bunting_width * unit), 1.15, 1.0}, .tint = color_of(i)});
    }
  }
}

// Trees, lamps and flags on the island between the two straights, where no agent stands.
void put_island(const ParadeSize& size, Placer& placer) {
  const double unit = placer.unit(), free = size.radius - size.inside;
  if (free < least_island * unit) return;
  const auto count = std::max(1, static_cast<int>(2.0 * size.half_length / (island_pitch * unit)));
  for (int i = 0; i <= count; ++i) {
    const glm::dvec2 at(size.half_length * (2.0 * i / count - 1.0), 0.0);
    if (i % 3 == 1) {
      placer.put(Prop::lamp, at, heading_along(towards_z));
    } else {
      placer.put_tree(at);
    }
  }
}

struct Rectangle {
  double x, z;  // metres from the origin to its sides
};

Rectangle houses_of(const ParadeSize& size, double unit) {
  const double beyond = size.radius + size.outside + pavement * unit;
  return {size.half_length + beyond, beyond};
}

void put_parade_houses(const Rectangle& houses, Placer& placer) {
  constexpr double street_width = 9.0, street_length = 51.0;
  const double unit = placer.unit(), out = street_length * unit, back = house_depth * unit;
  // Long sides with a street that leaves each.
  for (const double side : {-1.0, 1.0}) {
    const double at = side * 0.35 * houses.x, half = 0.5 * street_width * unit;
    const glm::dvec2 facing = -side * towards_z;
    placer.put_block({-houses.x, side * houses.z}, {at - half, side * houses.z}, facing, Placer::Houses::mixed);
    placer.put_block({at + half, side * houses.z}, {houses.x, side * houses.z}, facing, Placer::Houses::mixed);
    for (const double bank : {-1.0, 1.0}) {
      const glm::dvec2 mouth(at + bank * half, side * houses.z);
      placer.put_houses(mouth - back * facing, mouth - out * facing, -bank * towards_x, Placer::Houses::mixed);
    }
  }
  // The ends: an arcade at one; at the other, which the cameras look to, a street that goes on to the horizon.
  placer.put_block({houses.x, -houses.z}, {houses.x, houses.z}, -towards_x, Placer::Houses::arcades);
  const double half = std::min(0.5 * street_width * unit + 2.0 * unit, 0.5 * houses.z);
  for (const double bank : {-1.0, 1.0}) {
    placer.put_houses({-houses.x, bank * half}, {-houses.x, bank * houses.z}, towards_x, Placer::Houses::mixed);
    placer.put_houses({-houses.x - back, bank * half}, {-houses.x - out, bank * half}, -bank * towards_z,
                      Placer::Houses::mixed);
  }
  placer.put(Prop::tower, {-houses.x - out - 40.0 * unit, 9.0 * unit}, heading_along(towards_x));
  for (const double x : {-1.0, 1.0}) {  // the corners, which the loop leaves free
    for (const double z : {-1.0, 1.0}) placer.put_tree({x * (houses.x - 4.5 * unit), z * (houses.z - 4.5 * unit)});
  }
}

// Lights and a crane behind the actor, out of the way on which it comes.
void put_film_set(const CutSceneStreet& street, Placer& placer) {
  const double unit = placer.unit(), beside = street.half_road - 0.85 * unit;
  for (const double side : {-1.0, 1.0}) {
    const Heading inward = heading_along(glm::normalize(glm::dvec2(-side * 0.5, 1.0)));
    placer.put(Prop::stand, {side * beside, -7.0 * unit}, inward);
    placer.put(Prop::stand, {side * beside, std::min(street.last_end, 7.0 * unit)},
               heading_along(glm::normalize(glm::dvec2(-side * 0.4, -1.0))));
  }
  placer.put(Prop::camera_crane, {0.0, street.last_end + 4.0 * unit}, heading_along(-towards_z));
}

double film_houses(const CutSceneStreet& street, double unit) {
  return std::max(street.half_width + pavement * unit, 9.6 * unit);
}

}  // namespace

render::SceneGround put_parade(const SceneCrowd& crowd, Placer& placer) {
  const ParadeSize size = parade_size(crowd.agents, crowd.roles);
  put_barriers(size, placer);
  put_flags_and_lamps(size, placer);
  put_bunting(size, placer);
  put_island(size, placer);
  const double unit = placer.unit();
  const Rectangle houses = houses_of(size, unit);
  put_parade_houses(houses, placer);
  placer.put_horizon(houses.x);
  return {.style = render::GroundStyle::street,
          .unit = static_cast<float>(unit),
          .core = {size.half_length, 0.0},
          .radius = static_cast<float>(size.radius),
          .half_width = static_cast<float>(size.half_width + beyond_files * unit),
          .paved = static_cast<float>(size.outside + street_paved * unit)};
}

render::SceneGround put_film(const SceneCrowd& crowd, Placer& placer) {
  const double unit = placer.unit();
  const CutSceneStreet street = cut_scene_street(crowd.agents, crowd.roles);
  const double houses = film_houses(street, unit), far = street.first_end - 30.0 * unit;
  const double near = std::max(street.last_end, 13.0 * unit) + 24.0 * unit;
  for (const double side : {-1.0, 1.0}) {
    placer.put_houses({side * houses, far}, {side * houses, near}, -side * towards_x, Placer::Houses::mixed);
  }
  // The street ends at a square that it meets at its side, so that houses and some sky are seen.
  const double end = far - 16.0 * unit, wide = houses + 24.0 * unit;
  placer.put_houses({-wide, end}, {wide, end}, towards_z, Placer::Houses::arcades);
  placer.put(Prop::tower, {-0.6 * houses, end - 30.0 * unit}, heading_along(towards_z));
  put_film_set(street, placer);
  int turn = 0;
  for (double z = far + 4.0 * unit; z < near; z += 9.0 * unit, ++turn) {
    for (const double side : {-1.0, 1.0}) {
      const glm::dvec2 at(side * (houses - 1.1 * unit), z);
      placer.put(turn % 2 == 0 ? Prop::lamp : Prop::flag, at, heading_along(-side * towards_x),
                 {.tint = turn % 2 == 0 ? render::no_tint : color_of(turn / 2)});
    }
    if (turn % 2 != 0) continue;
    placer.put(Prop::bunting, {0.0, z}, heading_along(towards_z),
               {.stretch = {2.0 * houses / (bunting_width * unit), 1.15, 1.0}, .tint = color_of(turn / 2 + 1)});
  }
  placer.put_horizon(std::max(-far, houses));
  return {.style = render::GroundStyle::street,
          .unit = static_cast<float>(unit),
          .core = {0.0F, 1e5F * static_cast<float>(unit)},
          .half_width = static_cast<float>(street.half_road)};
}

}  // namespace throng::app
