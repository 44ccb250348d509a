#include "app/people/crowd/stadium.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/people/crowd/numbers/turn.h"
#include "app/people/place/scenes.h"

namespace throng::app {
namespace {

// Metres, for a person 1.8 m tall. A tread reaches from before the feet to the next riser.
constexpr double tread_front = 0.33, tread_back = 0.62;
constexpr double riser = 0.44;  // a little more than a tier rises
constexpr double longest_block = 18.0;
constexpr double wall_above = 1.0, wall_thick = 0.3;
constexpr double track_width = 4.0, apron = 0.45, around_field = 1.2;
constexpr double least_house = 5.0;  // height of the tiers from which houses stand around them
constexpr double arcade_height = 20.8;
constexpr double roof_height = 13.0, roof_reach = 14.0;
constexpr double flag_pitch = 5.0;
constexpr double stadium_paved = 14.0;  // around it, until the lawn begins
constexpr double to_park = 11.0;        // from the wall to the first trees

constexpr std::uint32_t home = tint_of(40, 92, 170), away = tint_of(196, 46, 44), neutral = tint_of(226, 222, 214);

std::uint32_t team_of(glm::dvec2 at, double half_length) {
  if (std::abs(at.x) < 0.12 * half_length) return neutral;
  return at.x < 0.0 ? home : away;
}

/// A straight piece of a ring: its middle, its outward heading and its length.
struct Chord {
  glm::dvec2 middle;
  Heading outward;
  double length;
};

/// Cuts the ring that lies `out` metres outside of a lane into pieces of at most `longest` metres.
std::vector<Chord> chords(const Lane& lane, double out, double longest) {
  std::vector<Chord> pieces;
  const double radius = lane.corner_radius + out;
  const auto add_side = [&](glm::dvec2 outward, double reach, double half) {
    const auto count = static_cast<int>(std::ceil(2.0 * half / longest));
    const glm::dvec2 along(outward.y, -outward.x);
    for (int i = 0; i < count; ++i) {
      const double at = half * (2.0 * (i + 0.5) / count - 1.0);
      pieces.push_back({reach * outward + at * along, heading_along(outward), 2.0 * half / count});
    }
  };
  for (const double side : {-1.0, 1.0}) {
    add_side({side, 0.0}, lane.core.x + radius, lane.core.y);
    add_side({0.0, side}, lane.core.y + radius, lane.core.x);
  }
  const double corner = std::numbers::pi / 2.0 * radius;
  const auto count = std::max(4, static_cast<int>(std::ceil(corner / std::min(longest, 0.2 * radius))));
  for (int quarter = 0; quarter < 4; ++quarter) {
    for (int i = 0; i < count; ++i) {
      const glm::dvec2 outward = cosine_sine(quarter + (i + 0.5) / count);
      const glm::dvec2 core = lane.core * glm::sign(outward);
      const double wide = 2.0 * radius * std::tan(std::numbers::pi / 4.0 / count);
      pieces.push_back({core + radius * outward, heading_along(outward), wide});
    }
  }
  return pieces;
}

Heading inward(const Heading& outward) { return {-outward.cosine, -outward.sine}; }

void put_tier(const StadiumTier& tier, double half_length, Placer& placer) {
  const double unit = placer.unit(), back = tread_back * unit, depth = (tread_front + tread_back) * unit;
  for (std::size_t seat = 0; seat < tier.seats; ++seat) {
    const LanePoint place = stadium_seat(tier, seat);
    const glm::dvec2 at = place.position - seat_behind_feet * unit * forward_of(place.heading);
    placer.put(Prop::seat, at, place.heading, {.height = tier.height, .tint = team_of(at, half_length)});
  }
  if (tier.height <= 0.0) return;
  // As long as their outer edges, so that no gap is left between them.
  for (const Chord& block : chords(tier.lane, back, longest_block * unit)) {
    placer.put(Prop::seat_block, block.middle - 0.5 * depth * forward_of(block.outward), inward(block.outward),
               {.height = tier.height, .stretch = glm::dvec3(block.length, riser * unit, depth) / unit});
  }
}

// A wall behind the last tier, with flags on it; houses around it where it is tall.
void put_back(const StadiumTier& last, double half_length, Placer& placer) {
  const double unit = placer.unit(), top = last.height + wall_above * unit;
  const double out = (tread_back + wall_thick) * unit;
  for (const Chord& wall : chords(last.lane, out, longest_block * unit)) {
    placer.put(Prop::seat_block, wall.middle - 0.5 * wall_thick * unit * forward_of(wall.outward), wall.outward,
               {.height = top, .stretch = glm::dvec3(wall.length, top, wall_thick * unit) / unit});
  }
  if (last.height > least_house * unit) {
    const double tall = (top + 0.3 * unit) / (arcade_height * unit);
    const double bay = bay_width * std::clamp(tall, 0.6, 1.3) * unit;
    for (const Chord& front : chords(last.lane, out + 0.8 * unit, bay)) {
      placer.put(Prop::arcade_bay, front.middle, front.outward,
                 {.stretch = {front.length / (bay_width * unit), tall, 0.1}});
    }
  }
  int number = 0;
  for (const Chord& top_edge : chords(last.lane, out - 0.5 * wall_thick * unit, flag_pitch * unit)) {
    const bool banner = number++ % 3 == 1;
    if (forward_of(top_edge.outward).y > 0.3) continue;  // the camera looks over that side
    placer.put(
        banner ? Prop::banner : Prop::flag, top_edge.middle, inward(top_edge.outward),
        {.height = top, .stretch = glm::dvec3(banner ? 0.75 : 0.6), .tint = team_of(top_edge.middle, half_length)});
  }
}

void put_field(const render::SceneGround& ground, Placer& placer) {
  const double unit = placer.unit();
  const glm::dvec2 half_sides =
      glm::dvec2(ground.core) + static_cast<double>(ground.radius - ground.half_width) - around_field * unit;
  const double size = std::clamp(half_sides.y / (34.0 * unit), 0.3, 1.0);
  for (const double side : {-1.0, 1.0}) {
    placer.put(Prop::goal, {side * half_sides.x, 0.0}, heading_along({-side, 0.0}), {.stretch = glm::dvec3(size)});
  }
}

void put_lights(const StadiumTier& last, double half_length, Placer& placer) {
  const double unit = placer.unit(), out = last.lane.corner_radius + 3.5 * unit;
  for (const double x : {-1.0, 1.0}) {
    for (const double z : {-1.0, 1.0}) {
      const glm::dvec2 outward = glm::normalize(glm::dvec2(x, z));
      const double tall = std::clamp((last.height + 0.35 * half_length + 6.0 * unit) / (30.0 * unit), 0.35, 1.5);
      placer.put(Prop::flood_light, glm::dvec2(x, z) * last.lane.core + out * outward, heading_along(-outward),
                 {.stretch = {std::sqrt(tall), tall, std::sqrt(tall)}});
    }
  }
}

// Rings of trees and lamps around it, with kiosks between them.
void put_park(const StadiumTier& last, Placer& placer) {
  const double unit = placer.unit(), out = tread_back + wall_thick;
  int number = 0;
  for (const Chord& spot : chords(last.lane, (out + to_park) * unit, 8.5 * unit)) {
    if (number % 9 == 4) {
      placer.put(Prop::kiosk, spot.middle, spot.outward);
    } else if (number % 3 == 1) {
      placer.put(Prop::lamp, spot.middle, spot.outward);
    } else {
      placer.put_tree(spot.middle);
    }
    ++number;
  }
  for (const double further : {9.0, 18.0, 30.0}) {
    for (const Chord& spot : chords(last.lane, (out + to_park + further) * unit, (8.0 + further) * unit)) {
      const auto aside = [&] { return 3.0 * unit * static_cast<double>(placer.random().between(-1.0F, 1.0F)); };
      placer.put_tree(spot.middle + glm::dvec2(aside(), aside()));
    }
  }
}

// Over the rows along the far side, from behind the wall.
void put_roof(const StadiumTier& last, double depth, Placer& placer) {
  const double unit = placer.unit(), length = 2.0 * last.lane.core.x;
  const auto bays = std::lround(length / (bay_width * unit));
  const double z = -(last.lane.core.y + last.lane.corner_radius + (tread_back + wall_thick) * unit);
  const double tall = std::clamp((last.height + 6.0 * unit) / (roof_height * unit), 0.5, 2.5);
  const double deep = std::clamp(0.8 * depth / (roof_reach * unit), 0.4, 1.2);
  for (long bay = 0; bay < bays; ++bay) {
    const double x = 0.5 * length * (2.0 * (static_cast<double>(bay) + 0.5) / static_cast<double>(bays) - 1.0);
    placer.put(Prop::roof_bay, {x, z}, heading_along(towards_z),
               {.stretch = {length / (static_cast<double>(bays) * bay_width * unit), tall, deep}});
  }
}

render::SceneGround stadium_ground(const std::vector<StadiumTier>& tiers, double unit) {
  const Lane &lowest = tiers.front().lane, &highest = tiers.back().lane;
  const double radius = lowest.corner_radius - apron * unit;
  return {.style = render::GroundStyle::pitch,
          .unit = static_cast<float>(unit),
          .core = lowest.core,
          .radius = static_cast<float>(radius),
          .half_width = static_cast<float>(std::min(track_width * unit, radius - 0.2 * unit)),
          .paved = static_cast<float>(highest.corner_radius - lowest.corner_radius + stadium_paved * unit)};
}

}  // namespace

render::SceneGround put_stadium(const SceneCrowd& crowd, Placer& placer) {
  const std::vector<StadiumTier> tiers = stadium_tiers(crowd.agents, crowd.roles);
  const double half_length = tiers.front().lane.core.x + tiers.front().lane.corner_radius;
  for (const StadiumTier& tier : tiers) put_tier(tier, half_length, placer);
  put_back(tiers.back(), half_length, placer);
  const render::SceneGround ground = stadium_ground(tiers, placer.unit());
  put_field(ground, placer);
  put_lights(tiers.back(), half_length, placer);
  put_park(tiers.back(), placer);
  const StadiumSize size = stadium_size(crowd.agents, crowd.roles);
  put_roof(tiers.back(), size.depth, placer);
  placer.put_horizon(tiers.back().lane.core.x + tiers.back().lane.corner_radius);
  return ground;
}

}  // namespace throng::app
