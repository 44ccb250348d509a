#include "app/character/gait_plane.h"

#include <utility>

#include <glm/geometric.hpp>

#include "engine/anim/agent/blend_space_2d_channel.h"

namespace throng::app {
namespace {

// A clip that goes nearly straight ahead, back or aside is placed exactly there, so that a person who walks straight
// ahead plays two clips and not three. A veering clip stays where it goes.
glm::vec2 place_of(const CharacterRoles& roles, Role gait) {
  constexpr double nearly = 0.966;  // the cosine of 15 degrees
  const glm::dvec2 velocity = roles.velocity(gait), way = way_of(gait);
  const double speed = glm::length(velocity);
  const bool along_an_axis = way.x == 0.0 || way.y == 0.0;
  return glm::vec2(along_an_axis && glm::dot(velocity, way) > nearly * speed ? way * speed : velocity);
}

// A gait ahead stands in for missing steps. It lies at twice its own speed, so that at its speed half of the blend is
// standing: feet rise and fall and hardly reach out.
GaitPoint stand_in(const CharacterRoles& roles, Role gait) {
  constexpr double out = 2.0;
  const Role steps = roles.ground_speed(Role::shuffle) > 0.0 ? Role::shuffle : Role::walk;
  return {.clip = roles.clip(steps), .velocity = glm::vec2(way_of(gait) * (out * roles.ground_speed(steps)))};
}

bool has_place(const std::vector<GaitPoint>& points, const glm::vec2& velocity) {
  constexpr float nearest = 0.05F;  // metres a second between two gaits
  for (const GaitPoint& point : points) {
    if (glm::distance(point.velocity, velocity) < nearest) return false;
  }
  return true;
}

}  // namespace

int standing_clip(const CharacterRoles& roles) {
  const int stand = roles.clip(Role::stand);
  if (stand != no_clip) return stand;
  return roles.others.empty() ? 0 : roles.others.front();
}

std::vector<GaitPoint> gait_points(const CharacterRoles& roles, Middle middle) {
  std::vector<GaitPoint> points{{.clip = standing_clip(roles), .is_gait = false}};
  if (!roles.can_walk()) return points;
  const int steps = roles.clip(Role::step_in_place);
  if (middle == Middle::steps && steps != no_clip) points.front() = {.clip = steps};
  const auto add = [&](const GaitPoint& point) {
    if (has_place(points, point.velocity)) points.push_back(point);
  };
  for (const Role gait : gait_roles) {
    if (roles.ground_speed(gait) > 0.0) add({.clip = roles.clip(gait), .velocity = place_of(roles, gait)});
  }
  for (const Role needed : {Role::walk_back, Role::step_left, Role::step_right}) {
    if (roles.ground_speed(needed) <= 0.0) add(stand_in(roles, needed));
  }
  return points;
}

Result<std::shared_ptr<const anim::BlendSpace2d>> gait_plane(const CharacterRoles& roles, int clip_count,
                                                             Middle middle) {
  std::vector<anim::BlendPoint2d> points;
  for (const GaitPoint& point : gait_points(roles, middle)) {
    points.push_back({.clip = point.clip, .place = point.velocity, .pace = point.is_gait ? Pace::gait : Pace::own});
  }
  return anim::BlendSpace2d::create(std::move(points), PlaneMeaning::velocity, clip_count);
}

}  // namespace throng::app
