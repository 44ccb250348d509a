#include "engine/anim/retarget/two_bone_reach.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "engine/anim/retarget/body_pose.h"

namespace throng::anim {

namespace {

constexpr double nearly_whole = 0.9995;  // of the leg's length: a straight leg would not know where its knee bends
constexpr double sharpest_knee = 0.94;   // cosine of the 20 degrees that thigh and shin leave between them
constexpr double straight = 1e-3;        // of the leg's length: a knee nearer to the line says no direction

glm::dvec3 across(const glm::dvec3& vector, const glm::dvec3& along) {
  return vector - along * glm::dot(vector, along);
}

}  // namespace

LegTurns reach(const LegPlaces& leg, const glm::dvec3& target, const glm::dvec3& forward) {
  const double upper = glm::distance(leg.hip, leg.knee), lower = glm::distance(leg.knee, leg.ankle);
  const double whole = upper + lower;
  LegTurns turns{.ankle = leg.ankle};
  if (!(std::min(upper, lower) > 1e-6 * whole) || !(glm::distance(target, leg.hip) > 1e-6 * whole)) return turns;
  const glm::dvec3 along = glm::normalize(target - leg.hip);
  const double shortest = std::sqrt(upper * upper + lower * lower - 2.0 * upper * lower * sharpest_knee);
  const double distance = std::clamp(glm::distance(target, leg.hip), shortest, nearly_whole * whole);
  const glm::dvec3 line = glm::normalize(leg.ankle - leg.hip);
  glm::dvec3 side = across(leg.knee - leg.hip, line);
  if (glm::length(side) < straight * whole) side = forward;
  side = turn_between(line, along) * side;
  side = across(side, along);
  if (!(glm::length(side) > 1e-9)) return turns;
  const double on_line = (upper * upper + distance * distance - lower * lower) / (2.0 * distance);
  const double off_line = std::sqrt(std::max(0.0, upper * upper - on_line * on_line));
  const glm::dvec3 knee = leg.hip + along * on_line + glm::normalize(side) * off_line;
  turns.ankle = leg.hip + along * distance;
  turns.upper = turn_between(leg.knee - leg.hip, knee - leg.hip);
  turns.lower = turn_between(leg.ankle - leg.knee, turns.ankle - knee);
  return turns;
}

double drop_to_reach(const LegPlaces& leg, const glm::dvec3& target) {
  const double whole = nearly_whole * (glm::distance(leg.hip, leg.knee) + glm::distance(leg.knee, leg.ankle));
  const double level = glm::length(glm::dvec2(target.x - leg.hip.x, target.z - leg.hip.z));
  if (level >= whole) return 0.0;
  return std::max(0.0, leg.hip.y - target.y - std::sqrt(whole * whole - level * level));
}

}  // namespace throng::anim
