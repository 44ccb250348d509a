#include "app/people/crowd/formation.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/people/crowd/numbers/turn.h"

namespace throng::app {
namespace {

// Metres, for a person 1.8 m tall. Neighbours stay 0.7 m apart and more.
constexpr double row_pitch = 1.14, out_of_line = 0.2;
constexpr double bend = 0.8, bend_length = 17.0;  // of the rows: straight ones would line up to the camera
constexpr double clear_of_obstacle = 0.6, clear_of_viewpoint = 4.6;

constexpr double unevenness_of_gaze = 0.12;  // quarter turns

// Each obstacle takes the ground that its neighbours keep clear.
std::vector<Obstacle> obstacles_within(double half, const FormationGround& ground) {
  std::vector<Obstacle> within;
  for (const Obstacle& obstacle : ground.obstacles) {
    const glm::dvec2 away = glm::abs(obstacle.position);
    const double taken = obstacle.radius + clear_of_obstacle * ground.spacing;
    if (std::max(away.x, away.y) < half + taken) within.push_back({obstacle.position, taken});
  }
  within.push_back({ground.viewpoint, clear_of_viewpoint * ground.spacing});
  return within;
}

glm::dvec2 bent(glm::dvec2 place, double spacing) {
  const glm::dvec2 quarters = place * (4.0 / (bend_length * spacing));
  return place + bend * spacing * glm::dvec2(cosine_sine(quarters.y).y, cosine_sine(quarters.x).y);
}

/// Returns the places of a square of `rows` times `rows` that are free. Every other row is shifted, so that people look
/// between the shoulders of the row before them.
std::vector<glm::dvec2> free_places(int rows, const FormationGround& ground, Random& random) {
  const double step = row_pitch * ground.spacing;
  const auto off = [&] { return out_of_line * ground.spacing * static_cast<double>(random.between(-1.0F, 1.0F)); };
  const std::vector<Obstacle> obstacles = obstacles_within(0.5 * (rows + 1) * step, ground);
  std::vector<glm::dvec2> places;
  for (int row = 0; row < rows; ++row) {
    const double shift = row % 2 == 0 ? -0.25 : 0.25;
    for (int column = 0; column < rows; ++column) {
      const glm::dvec2 line(column - 0.5 * (rows - 1) + shift, row - 0.5 * (rows - 1));
      const glm::dvec2 place = bent(step * line, ground.spacing) + glm::dvec2(off(), off());
      const auto is_taken = [&](const Obstacle& taken) { return glm::distance(taken.position, place) < taken.radius; };
      if (std::ranges::none_of(obstacles, is_taken)) places.push_back(place);
    }
  }
  return places;
}

Heading looking_at(glm::dvec2 viewpoint, glm::dvec2 from, Random& random) {
  const glm::dvec2 way = viewpoint - from;
  const double away = glm::length(way);
  const glm::dvec2 ahead = away > 0.0 ? way / away : glm::dvec2(0.0, 1.0);
  const glm::dvec2 turn = cosine_sine(unevenness_of_gaze * static_cast<double>(random.between(-1.0F, 1.0F)));
  return heading_along({turn.x * ahead.x - turn.y * ahead.y, turn.y * ahead.x + turn.x * ahead.y});
}

}  // namespace

std::vector<StanderStart> stand_in_formation(std::size_t people, const FormationGround& ground, Random random) {
  auto rows = std::max(1, static_cast<int>(ground.side / (row_pitch * ground.spacing)));
  std::vector<glm::dvec2> places = free_places(rows, ground, random);
  while (places.size() < people) places = free_places(++rows, ground, random);
  std::vector<StanderStart> standers;
  standers.reserve(people);
  for (std::size_t i = 0; i < places.size() && standers.size() < people; ++i) {
    // The places that are left over are spread evenly.
    const auto left = static_cast<std::uint32_t>(places.size() - i);
    if (random.below(left) >= people - standers.size()) continue;
    standers.push_back({.position = places[i], .heading = looking_at(ground.viewpoint, places[i], random)});
  }
  return standers;
}

}  // namespace throng::app
