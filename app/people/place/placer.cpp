#include "app/people/place/placer.h"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "app/people/crowd/numbers/turn.h"

namespace throng::app {
namespace {

// Plaster and stone as a town in the south has it.
constexpr std::array<std::uint32_t, 8> walls{tint_of(255, 250, 240), tint_of(250, 226, 190), tint_of(238, 205, 170),
                                             tint_of(247, 236, 214), tint_of(232, 196, 158), tint_of(240, 222, 206),
                                             tint_of(222, 206, 184), tint_of(248, 216, 176)};
constexpr std::uint32_t front_count = 5;
constexpr std::array<Prop, front_count> fronts{Prop::facade_a, Prop::facade_b, Prop::facade_c, Prop::facade_d,
                                               Prop::facade_e};

constexpr double to_horizon = 420.0;  // metres beyond a place
constexpr int hills = 18, roofs = 22;

Heading turned_by(double quarters) { return heading_along(cosine_sine(quarters)); }

}  // namespace

void Placer::put(Prop prop, glm::dvec2 at, const Heading& heading, const Stance& stance) {
  const glm::dvec2 x = beside(heading), z = forward_of(heading);
  const glm::dvec3 stretch = unit_ * stance.stretch;
  glm::mat4x3 place;
  place[0] = glm::vec3(stretch.x * x.x, 0.0, stretch.x * x.y);
  place[1] = glm::vec3(0.0, stretch.y, 0.0);
  place[2] = glm::vec3(stretch.z * z.x, 0.0, stretch.z * z.y);
  place[3] = glm::vec3(at.x, stance.height, at.y);
  place_.props.push_back({prop, place, stance.tint});
}

void Placer::put_houses(glm::dvec2 from, glm::dvec2 to, glm::dvec2 facing, Houses houses) {
  const double length = glm::distance(from, to);
  const long bays = std::lround(length / (bay_width * unit_));
  if (bays < 1) return;
  const glm::dvec2 step = (to - from) / static_cast<double>(bays);
  const double stretch = length / (static_cast<double>(bays) * bay_width * unit_);
  const Heading heading = heading_along(facing);
  std::uint32_t left_of_house = 0, front = random_.below(front_count), wall = 0;
  double tall = 1.0;
  for (long bay = 0; bay < bays; ++bay) {
    const bool ends_row = bay == 0 || bay + 1 == bays;  // where a side is seen
    if (left_of_house == 0 || ends_row) {
      left_of_house = ends_row ? 1 : 1 + random_.below(3);
      front = (front + 1 + random_.below(front_count - 1)) % front_count;  // never two equal fronts side by side
      wall = walls[random_.below(walls.size())];
      tall = static_cast<double>(random_.between(0.92F, 1.08F));
    }
    --left_of_house;
    const bool arcade = houses == Houses::arcades;
    const Prop inner = arcade ? Prop::arcade_bay : fronts[front];
    const Prop end = arcade ? Prop::arcade_corner : Prop::facade_corner;
    const glm::dvec2 at = from + (static_cast<double>(bay) + 0.5) * step;
    put(ends_row ? end : inner, at, heading,
        {.stretch = {stretch, arcade ? 1.0 : tall, 1.0}, .tint = arcade ? render::no_tint : wall});
  }
}

void Placer::put_block(glm::dvec2 from, glm::dvec2 to, glm::dvec2 facing, Houses houses) {
  put_houses(from, to, facing, houses);
  const double length = glm::distance(from, to);
  if (length < 4.0 * house_depth * unit_) return;
  const glm::dvec2 inset = (house_depth + 0.4) * unit_ * (to - from) / length;
  const glm::dvec2 behind = -2.0 * house_depth * unit_ * facing;
  put_houses(to - inset + behind, from + inset + behind, -facing, Houses::mixed);
}

void Placer::put_tree(glm::dvec2 at) {
  constexpr std::array<Prop, 3> trees{Prop::tree_a, Prop::tree_b, Prop::tree_c};
  const auto size = static_cast<double>(random_.between(0.85F, 1.1F));
  const Prop tree = trees[random_.below(3)];
  const auto shade = static_cast<std::uint32_t>(random_.between(215.0F, 255.0F));
  put(tree, at, turned_by(4.0 * static_cast<double>(random_.unit())),
      {.stretch = glm::dvec3(size), .tint = tint_of(shade, 255, shade)});
}

void Placer::put_horizon(double reach) {
  const double far = reach + to_horizon * unit_;
  for (int hill = 0; hill < hills; ++hill) {
    const double quarters = 4.0 * (hill + static_cast<double>(random_.between(-0.3F, 0.3F))) / hills;
    const glm::dvec2 way = cosine_sine(quarters);
    const auto size = static_cast<double>(random_.between(0.8F, 1.5F));
    put(Prop::hill, way * (far * static_cast<double>(random_.between(1.5F, 2.2F))), heading_along(-way),
        {.stretch = {size * far / (to_horizon * unit_), size, 1.0}});
  }
  for (int roof = 0; roof < roofs; ++roof) {
    const double quarters = 4.0 * (roof + static_cast<double>(random_.between(-0.4F, 0.4F))) / roofs;
    const glm::dvec2 way = cosine_sine(quarters);
    const auto away = static_cast<double>(random_.between(0.8F, 1.7F)),
               tall = static_cast<double>(random_.between(0.6F, 1.2F));
    const auto wide = static_cast<double>(random_.between(0.7F, 1.4F)) * (random_.chance(0.5F) ? 1.0 : -1.0);
    if (random_.chance(0.3F)) continue;                                       // so that hills show between the roofs
    const Prop town = roof % 11 == 3 ? Prop::skyline_center : Prop::skyline;  // domes are rare
    put(town, way * (far * away), heading_along(-way), {.stretch = {wide * far / (to_horizon * unit_), tall, 1.0}});
  }
}

}  // namespace throng::app
