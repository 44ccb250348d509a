#include "app/character/gait_plane.h"

#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace throng::app {
namespace {

// A clip that goes nearly where its name says is placed exactly there, so that who walks straight ahead plays two clips
// and not three.
glm::dvec2 place_of(const CharacterRoles& roles, Role gait) {
  constexpr double nearly = 0.966;  // the cosine of 15 degrees
  const glm::dvec2 velocity = roles.velocity(gait);
  const double speed = glm::length(velocity);
  return glm::dot(velocity, way_of(gait)) > nearly * speed ? way_of(gait) * speed : velocity;
}

int standing_clip(const CharacterRoles& roles) {
  const int stand = roles.clip(Role::stand);
  if (stand != no_clip) return stand;
  return roles.others.empty() ? 0 : roles.others.front();
}

// Steps ahead in the place of steps that there are not. It lies twice as far out as it is fast, so that at its speed
// half of it is standing: feet rise and fall and hardly reach out.
anim::BlendPoint2d stand_in(const CharacterRoles& roles, Role gait) {
  constexpr double out = 2.0;
  const Role steps = roles.ground_speed(Role::shuffle) > 0.0 ? Role::shuffle : Role::walk;
  return {.clip = roles.clip(steps), .place = glm::vec2(way_of(gait) * (out * roles.ground_speed(steps)))};
}

}  // namespace

anim::Result<std::shared_ptr<const anim::BlendSpace2d>> gait_plane(const CharacterRoles& roles, int clip_count) {
  std::vector<anim::BlendPoint2d> points{{.clip = standing_clip(roles)}};
  for (const Role gait : gait_roles) {
    if (!roles.can_walk()) break;
    const bool leads_on = way_of(gait).y > 0.0;
    if (roles.ground_speed(gait) > 0.0) {
      points.push_back({.clip = roles.clip(gait), .place = glm::vec2(place_of(roles, gait))});
    } else if (!leads_on) {
      points.push_back(stand_in(roles, gait));
    }
  }
  return anim::BlendSpace2d::create(std::move(points), anim::PlaneMeaning::velocity, clip_count);
}

}  // namespace throng::app
