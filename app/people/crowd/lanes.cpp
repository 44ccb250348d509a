#include "app/people/crowd/lanes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/people/crowd/numbers/turn.h"

namespace throng::app {
namespace {

struct PathPoint {
  glm::dvec2 offset;   // from the lane's centre
  glm::dvec2 tangent;  // unit, counter-clockwise in x, z
};

double half_length(const Lane& lane) {
  return 2.0 * (lane.core.x + lane.core.y) + std::numbers::pi * lane.corner_radius;
}

// One half of the loop: a side, a corner, a side, a corner; the other half is its mirror image through the centre.
PathPoint along_half(const Lane& lane, double distance) {
  const double radius = lane.corner_radius;
  const double corner = radius * std::numbers::pi / 2.0;
  if (distance < 2.0 * lane.core.y) return {{lane.core.x + radius, distance - lane.core.y}, {0.0, 1.0}};
  distance -= 2.0 * lane.core.y;
  if (distance < corner) {
    const glm::dvec2 turn = cosine_sine(distance / corner);
    return {lane.core + radius * turn, {-turn.y, turn.x}};
  }
  distance -= corner;
  if (distance < 2.0 * lane.core.x) return {{lane.core.x - distance, lane.core.y + radius}, {-1.0, 0.0}};
  distance -= 2.0 * lane.core.x;
  const glm::dvec2 turn = cosine_sine(distance / corner);
  return {{-lane.core.x - radius * turn.y, lane.core.y + radius * turn.x}, {-turn.x, -turn.y}};
}

}  // namespace

double Lane::length() const { return 2.0 * half_length(*this); }

LanePoint Lane::at(double distance) const {
  const double half = half_length(*this);
  const double halves = std::floor(distance * direction / half);
  const PathPoint point = along_half(*this, std::max(0.0, distance * direction - halves * half));
  const double side = (static_cast<long long>(halves) & 1) != 0 ? -1.0 : 1.0;
  const glm::dvec2 forward = side * direction * point.tangent;
  return {centre + side * point.offset, {static_cast<float>(forward.y), static_cast<float>(forward.x)}};
}

double Lane::signed_distance(glm::dvec2 point) const {
  const glm::dvec2 beyond = glm::abs(point - centre) - core;
  const double outside = glm::length(glm::max(beyond, glm::dvec2(0.0)));
  return outside + std::min(0.0, std::max(beyond.x, beyond.y)) - corner_radius;
}

}  // namespace throng::app
