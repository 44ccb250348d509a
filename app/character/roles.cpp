#include "app/character/roles.h"

#include <string_view>

#include <glm/geometric.hpp>

#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

using anim::any_begins_with;
using Words = anim::ClipWords;

constexpr std::array<std::string_view, 12> not_for_a_crowd{"pose", "death", "die",  "dead", "land",   "start",
                                                           "end",  "lie",   "fall", "hit",  "defeat", "down"};

int clip_with_words(std::span<const Words> names, std::string_view one, std::string_view other) {
  const auto found = std::ranges::find_if(
      names, [&](const Words& words) { return any_begins_with(words, one) && any_begins_with(words, other); });
  return found == names.end() ? no_clip : static_cast<int>(found - names.begin());
}

std::vector<int> clips_for_any_role(std::span<const Words> names) {
  std::vector<int> fit, all;
  for (std::size_t clip = 0; clip < names.size(); ++clip) {
    all.push_back(static_cast<int>(clip));
    const auto is_in_name = [&](std::string_view word) { return any_begins_with(names[clip], word); };
    if (std::ranges::none_of(not_for_a_crowd, is_in_name)) fit.push_back(static_cast<int>(clip));
  }
  return fit.empty() ? all : fit;
}

}  // namespace

std::string known_roles() { return joined(role_names, ", ", " and "); }

glm::dvec2 way_of(Role gait) {
  constexpr double aside_of_veering = 0.316, ahead_of_veering = 0.949;  // one part aside to three ahead
  switch (gait) {
    case Role::walk_back:
      return {0.0, -1.0};
    case Role::step_left:
      return {1.0, 0.0};
    case Role::step_right:
      return {-1.0, 0.0};
    case Role::veer_left:
      return {aside_of_veering, ahead_of_veering};
    case Role::veer_right:
      return {-aside_of_veering, ahead_of_veering};
    default:
      return {0.0, 1.0};
  }
}

double CharacterRoles::ground_speed(Role gait) const {
  if (clip(gait) == no_clip) return 0.0;
  switch (gait) {
    case Role::walk:
      return walk_speed;
    case Role::jog:
      return jog_speed;
    case Role::run:
      return run_speed;
    default:
      return glm::length(velocities[index_of(gait)]);
  }
}

glm::dvec2 CharacterRoles::velocity(Role gait) const {
  const glm::dvec2& measured = velocities[index_of(gait)];
  const double speed = ground_speed(gait);
  return speed > 0.0 && measured != glm::dvec2(0.0) ? measured : glm::dvec2(0.0, speed);
}

std::optional<Role> CharacterRoles::playable(Role role) const {
  switch (role) {
    case Role::run:
      return ground_speed(role) > 0.0 ? role : playable(Role::jog);
    case Role::jog:
      return ground_speed(role) > 0.0 ? role : playable(Role::walk);
    case Role::walk:
      return can_walk() ? std::optional(role) : std::nullopt;
    case Role::look_around:
    case Role::sit:
      return clip(role) != no_clip ? role : playable(Role::stand);
    default:
      return clip(role) != no_clip ? std::optional(role) : std::nullopt;
  }
}

CharacterRoles roles_by_name(std::span<const std::string> clip_names) {
  std::vector<Words> names;
  names.reserve(clip_names.size());
  for (const std::string& name : clip_names) names.push_back(anim::words_of_clip(name));

  CharacterRoles roles;
  roles.clips = anim::roles_of_clips(clip_names);
  roles.others = clips_for_any_role(names);
  roles.sit_down.clip = clip_with_words(names, "sit", "down");
  roles.stand_up.clip = clip_with_words(names, "stand", "up");
  return roles;
}

}  // namespace throng::app
