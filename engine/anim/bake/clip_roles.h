#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace throng::anim {

/// The purpose of a clip.
enum class ClipRole : std::uint8_t {
  stand,
  look_around,
  walk,
  jog,
  run,
  wave,
  cheer,
  clap,
  sit,
  walk_back,  // from here on for a person on a recorded track
  step_left,
  step_right,
  shuffle,
  step_in_place,
  veer_left,
  veer_right,
  talk,
  phone,  // from here on for a person who holds something, or rests
  call,
  drink,
  take_picture,
  lean,
  sit_on_step,
  carry,  // from here on for an arm, over the motion of the body
  hold_up,
  hold_phone,
  lead,
  led,
  push,
  stick,
  other
};
inline constexpr std::size_t clip_role_count = 30;  ///< roles that one clip fills; `other` is any clip

/// The names of the roles, in the order of ClipRole.
inline constexpr std::array<const char*, clip_role_count> clip_role_names = {
    "stand",   "look_around", "walk",      "jog",        "run",          "wave",          "cheer",       "clap",
    "sit",     "walk_back",   "step_left", "step_right", "shuffle",      "step_in_place", "veer_left",   "veer_right",
    "talk",    "phone",       "call",      "drink",      "take_picture", "lean",          "sit_on_step", "carry",
    "hold_up", "hold_phone",  "lead",      "led",        "push",         "stick"};
std::optional<ClipRole> role_named(std::string_view name);

inline constexpr int no_clip = -1;
using RoleClips = std::array<int, clip_role_count>;  ///< index of a clip or no_clip, by ClipRole

using ClipWords = std::vector<std::string>;

/// Returns the words of a clip's name in small letters: "CharacterArmature|Walk_Gun" is walk, gun; "Robot_WalkJump" is
/// robot, walk, jump; digits separate words.
ClipWords words_of_clip(std::string_view name);
/// Returns whether a word begins with `beginning`. A single letter is a whole word: the l of Strafe_L.
bool any_begins_with(const ClipWords& words, std::string_view beginning);

/// Guesses which clip plays which role from the names of clips as artists write them: "Idle", "Walking_A",
/// "CharacterArmature|Wave". The plainest name wins; a run stands in for a walk. An empty name plays nothing.
RoleClips roles_of_clips(std::span<const std::string> clip_names);

}  // namespace throng::anim
