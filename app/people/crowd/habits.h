#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "app/character/held.h"
#include "app/character/roles.h"
#include "engine/base/random.h"

namespace throng::app {

/// The reason why an agent is there. It decides which transitions between roles the agent makes.
enum class Habit : std::uint8_t {
  stroll,       ///< walks the lanes of a plaza, stops, goes on, runs now and then
  stand_about,  ///< stands where it is, in a group or in a row of the grid
  march,        ///< walks in rank and file and does nothing else
  watch,        ///< stands beside a parade
  sit,          ///< has a seat in the stadium
  rest,         ///< has a seat on a bench or on the rim of a fountain
  lean,         ///< leans against a trunk or a wall
  sit_low,      ///< sits on a step
  wait,         ///< stands alone, or beside a person who takes a picture
  photograph,   ///< takes pictures, with the camera that it holds
  pose,         ///< stands before a camera
  train,        ///< runs round the stadium's field
  act,          ///< does what a script says (CutScene)
  follow,       ///< is where a recorded crowd has it (Followers)
  accompany,    ///< walks and stops beside an agent that strolls (Company)
};

/// Words that say what each habit is, in its order.
inline constexpr std::array<const char*, 15> habit_words = {
    "strolls", "stands about",           "marches",      "watches",        "has a seat",          "rests on a bench",
    "leans",   "sits on a step",         "waits",        "takes pictures", "poses for a picture", "trains",
    "acts",    "is where its file says", "keeps company"};
static_assert(static_cast<std::size_t>(Habit::accompany) + 1 == habit_words.size());

/// One arrow of the state machine: an agent of `habit` that has done `from` for long enough may go over to `to`, in
/// proportion to `weight`, if the thing in its hand allows it.
struct Transition {
  Habit habit;
  Role from, to;
  float weight;
};

/// Returns all transitions. Nothing else ever happens.
std::span<const Transition> transitions();

/// The seconds that a role is kept.
struct Stay {
  float least, most;
};
Stay stay_in(Role role);

/// Returns the role that an agent of `habit` begins with, as far as the character has a clip for it.
Role first_role(Habit habit, const CharacterRoles& character, Random& whim, HeldThing held = HeldThing::nothing);

/// Returns the role that follows `from`, by a transition whose role the character can play with the thing that it
/// holds; `from` if there is none.
Role next_role(Habit habit, Role from, const CharacterRoles& character, Random& whim,
               HeldThing held = HeldThing::nothing);

constexpr bool is_gait(Role role) { return role == Role::walk || role == Role::jog || role == Role::run; }

}  // namespace throng::app
