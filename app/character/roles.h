#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "engine/anim/bake/clip_roles.h"

namespace throng::app {

/// The things that a member of the crowd can do, and the names that `--clips`, the role file and the overlay use.
using Role = anim::ClipRole;
inline constexpr std::size_t role_count = anim::clip_role_count;
inline constexpr std::array<const char*, role_count> role_names = anim::clip_role_names;
using anim::role_named;
std::string known_roles();  ///< "stand, look_around, ... and talk"
inline std::size_t index_of(Role role) { return static_cast<std::size_t>(role); }

/// A person's choice of the clip that plays a role; "none" is no clip at all.
struct RoleChoice {
  Role role;
  std::string clip;

  friend bool operator==(const RoleChoice&, const RoleChoice&) = default;
};
inline constexpr const char* no_clip_name = "none";

inline constexpr int no_clip = anim::no_clip;
using RoleClips = anim::RoleClips;
constexpr RoleClips no_clips() {
  RoleClips clips{};
  clips.fill(no_clip);
  return clips;
}

/// A clip that leads from one role to another, played once.
struct Passage {
  int clip = no_clip;  ///< no_clip: the one fades into the other
  double seconds = 0.0;
};

/// The roles that go somewhere, slowest ahead first.
inline constexpr std::array<Role, 9> gait_roles = {Role::shuffle,    Role::walk,      Role::jog,
                                                   Role::run,        Role::walk_back, Role::step_left,
                                                   Role::step_right, Role::veer_left, Role::veer_right};

/// Returns the way that a gait goes, as its name says: to the left and ahead. It has the length 1.
glm::dvec2 way_of(Role gait);

/// Metres a second to the left and ahead, by Role; 0 for other roles.
using RoleVelocities = std::array<glm::dvec2, role_count>;
constexpr RoleVelocities no_velocities() {
  RoleVelocities velocities{};
  velocities.fill(glm::dvec2(0.0));
  return velocities;
}

inline constexpr double person_height = 1.8;  ///< metres; every distance of a scene is meant for this height

/// Small animals keep at least this share of people's distances, because a place is made for people.
inline constexpr double least_spacing = 0.6;

/// A kind of body that some agents of a character have, such as woman, man or child.
struct BodyKind {
  double share = 1.0;  ///< beside the shares of the others
  double size = 1.0;   ///< over the file's

  bool is_child() const { return size < 0.8; }
};

/// The clips of a character that the crowd plays for each role, and the body that it needs room for.
struct CharacterRoles {
  RoleClips clips = no_clips();
  std::vector<int> others;     ///< clips that agents play in place, in turns, where there is no clip to stand with
  Passage sit_down, stand_up;  ///< into `sit` and out of it
  double walk_speed = 0.0;     ///< metres a second of the walk clip itself, at scale 1; 0: no agent walks
  double jog_speed = 0.0;      ///< of the jog clip; 0: agents that would jog walk
  double run_speed = 0.0;      ///< of the run clip; 0: agents that would run jog or walk
  RoleVelocities velocities = no_velocities();  ///< of the clips of gaits themselves, at scale 1; 0: no such gait
  double walk_seconds = 1.0;                    ///< length of the walk clip: one left and one right step
  std::vector<double> turns;      ///< [clip] quarter turns a second to the left of its root motion; empty: none turns
  double height = person_height;  ///< metres
  double radius = 0.3;            ///< metres; radius of the body seen from above, arms down
  bool is_prop = false;           ///< a thing: it stands only where a scene asks for one
  bool is_painted = false;        ///< its colours are its file's own: agents differ in shade, not in clothes
  double share = 1.0;             ///< of the crowd, beside the shares of the others
  std::vector<BodyKind> bodies = {};  ///< empty: all have the file's body

  int clip(Role role) const { return role == Role::other ? no_clip : clips[index_of(role)]; }
  /// Returns the quarter turns a second that a clip makes to the left.
  double turn(int clip) const {
    const auto index = static_cast<std::size_t>(clip);
    return clip == no_clip || index >= turns.size() ? 0.0 : turns[index];
  }
  /// Returns the character's height over that of a person.
  double size() const { return height / person_height; }
  /// Returns how much more room the character needs than a person 1.8 metres tall, but at least least_spacing. Every
  /// distance of a scene is multiplied by it.
  double spacing() const { return std::max({size(), radius / 0.5, least_spacing}); }
  bool can_walk() const { return clip(Role::walk) != no_clip && walk_speed > 0.0; }
  /// Returns the metres a second of a gait's clip at scale 1; 0 if there is no such clip, it stays in place, or it goes
  /// another way than its role says.
  double ground_speed(Role gait) const;
  /// Returns the velocity of a gait's clip: metres a second to the left and ahead. A walk, jog or run goes ahead,
  /// whatever its clip does.
  glm::dvec2 velocity(Role gait) const;
  /// Returns the role that is played for `role`: itself, else the nearest one (run, jog, walk; sit or look_around,
  /// stand); nothing if these have no clip either.
  std::optional<Role> playable(Role role) const;
};

/// Guesses roles from clip names (anim::roles_of_clips). Fills `clips`, `others` and the clips of passages and leaves
/// the rest to the caller.
CharacterRoles roles_by_name(std::span<const std::string> clip_names);

}  // namespace throng::app
