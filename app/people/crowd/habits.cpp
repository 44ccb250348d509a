#include "app/people/crowd/habits.h"

namespace throng::app {
namespace {

using enum anim::ClipRole;

constexpr Transition all_transitions[] = {
    // Strollers walk, stop to look, greet a person, and hurry when they are late. From walk to walk is another way.
    {Habit::stroll, walk, walk, 3.0F},
    {Habit::stroll, walk, look_around, 1.0F},
    {Habit::stroll, walk, stand, 1.0F},
    {Habit::stroll, walk, wave, 0.7F},
    {Habit::stroll, walk, jog, 1.0F},
    {Habit::stroll, walk, run, 0.5F},
    {Habit::stroll, stand, walk, 3.0F},
    {Habit::stroll, stand, look_around, 1.0F},
    {Habit::stroll, look_around, walk, 1.0F},
    {Habit::stroll, wave, walk, 1.0F},
    {Habit::stroll, jog, walk, 2.0F},
    {Habit::stroll, jog, run, 1.0F},
    {Habit::stroll, run, jog, 1.0F},
    {Habit::stroll, run, walk, 1.0F},
    // People stop to use the phone, the cup or the camera that they hold.
    {Habit::stroll, walk, phone, 0.7F},
    {Habit::stroll, walk, call, 0.4F},
    {Habit::stroll, walk, drink, 0.7F},
    {Habit::stroll, walk, take_picture, 1.0F},
    {Habit::stroll, phone, walk, 1.0F},
    {Habit::stroll, call, walk, 1.0F},
    {Habit::stroll, drink, walk, 1.0F},
    {Habit::stroll, take_picture, walk, 2.0F},
    {Habit::stroll, take_picture, look_around, 1.0F},
    // People who stand about talk with their hands, and rest in between.
    {Habit::stand_about, stand, look_around, 1.0F},
    {Habit::stand_about, stand, wave, 1.0F},
    {Habit::stand_about, stand, cheer, 1.0F},
    {Habit::stand_about, stand, clap, 1.0F},
    {Habit::stand_about, look_around, stand, 1.0F},
    {Habit::stand_about, wave, stand, 1.0F},
    {Habit::stand_about, cheer, stand, 1.0F},
    {Habit::stand_about, clap, stand, 1.0F},
    {Habit::stand_about, stand, phone, 2.0F},
    {Habit::stand_about, stand, call, 0.7F},
    {Habit::stand_about, stand, drink, 2.0F},
    {Habit::stand_about, stand, take_picture, 1.5F},
    {Habit::stand_about, phone, stand, 1.0F},
    {Habit::stand_about, call, stand, 1.0F},
    {Habit::stand_about, drink, stand, 1.0F},
    {Habit::stand_about, take_picture, stand, 1.0F},
    // A parade's spectators are rarely still.
    {Habit::watch, stand, cheer, 2.0F},
    {Habit::watch, stand, wave, 2.0F},
    {Habit::watch, stand, clap, 2.0F},
    {Habit::watch, cheer, wave, 1.0F},
    {Habit::watch, cheer, clap, 1.0F},
    {Habit::watch, cheer, stand, 1.0F},
    {Habit::watch, wave, cheer, 1.0F},
    {Habit::watch, wave, stand, 2.0F},
    {Habit::watch, clap, cheer, 1.0F},
    {Habit::watch, clap, stand, 2.0F},
    {Habit::watch, stand, take_picture, 3.0F},
    {Habit::watch, stand, drink, 1.0F},
    {Habit::watch, take_picture, stand, 1.0F},
    {Habit::watch, drink, stand, 1.0F},
    // A stadium sits, and applauds; the wave that runs round makes it cheer besides.
    {Habit::sit, sit, clap, 2.0F},
    {Habit::sit, sit, wave, 1.0F},
    {Habit::sit, sit, cheer, 0.5F},
    {Habit::sit, clap, sit, 1.0F},
    {Habit::sit, wave, sit, 1.0F},
    {Habit::sit, cheer, sit, 1.0F},
    // People who rest on a bench get up now and then.
    {Habit::rest, sit, look_around, 1.0F},
    {Habit::rest, look_around, sit, 1.0F},
    // People who lean come away from the wall for a phone, a cup or a camera, or to look for a friend.
    {Habit::lean, lean, lean, 2.0F},
    {Habit::lean, lean, look_around, 0.5F},
    {Habit::lean, lean, phone, 2.0F},
    {Habit::lean, lean, call, 1.0F},
    {Habit::lean, lean, drink, 2.0F},
    {Habit::lean, lean, take_picture, 1.0F},
    {Habit::lean, look_around, lean, 1.0F},
    {Habit::lean, phone, lean, 1.0F},
    {Habit::lean, call, lean, 1.0F},
    {Habit::lean, drink, lean, 1.0F},
    {Habit::lean, take_picture, lean, 1.0F},
    // People who wait look around for a friend, and at their phones.
    {Habit::wait, stand, look_around, 2.0F},
    {Habit::wait, stand, phone, 3.0F},
    {Habit::wait, stand, call, 1.0F},
    {Habit::wait, stand, drink, 2.0F},
    {Habit::wait, stand, take_picture, 1.0F},
    {Habit::wait, look_around, stand, 1.0F},
    {Habit::wait, phone, look_around, 1.0F},
    {Habit::wait, phone, stand, 1.0F},
    {Habit::wait, call, stand, 1.0F},
    {Habit::wait, drink, stand, 1.0F},
    {Habit::wait, take_picture, stand, 1.0F},
    // People before a camera hold still, and wave now and then.
    {Habit::photograph, take_picture, stand, 1.0F},
    {Habit::photograph, take_picture, look_around, 0.3F},
    {Habit::photograph, stand, take_picture, 1.0F},
    {Habit::photograph, look_around, take_picture, 1.0F},
    {Habit::pose, stand, wave, 1.0F},
    {Habit::pose, stand, stand, 1.0F},
    {Habit::pose, wave, stand, 1.0F},
    // Athletes warm up, sprint, and get their breath back.
    {Habit::train, jog, run, 2.0F},
    {Habit::train, jog, walk, 1.0F},
    {Habit::train, run, jog, 2.0F},
    {Habit::train, run, walk, 1.0F},
    {Habit::train, walk, jog, 3.0F},
    {Habit::train, walk, stand, 0.5F},
    {Habit::train, stand, walk, 1.0F},
};

constexpr Stay stays[] = {
    {4.0F, 14.0F},  // stand
    {3.0F, 7.0F},   // look_around
    {8.0F, 24.0F},  // walk
    {5.0F, 12.0F},  // jog
    {3.0F, 7.0F},   // run
    {2.5F, 6.0F},   // wave
    {2.5F, 6.0F},   // cheer
    {2.5F, 6.0F},   // clap
    {6.0F, 24.0F},  // sit
    {8.0F, 24.0F},  // walk_back
    {8.0F, 24.0F},  // step_left
    {8.0F, 24.0F},  // step_right
    {8.0F, 24.0F},  // shuffle
    {8.0F, 24.0F},  // step_in_place
    {8.0F, 24.0F},  // veer_left
    {8.0F, 24.0F},  // veer_right
    {4.0F, 14.0F},  // talk
    {8.0F, 24.0F},  // phone
    {8.0F, 24.0F},  // call
    {8.0F, 16.0F},  // drink
    {6.0F, 12.0F},  // take_picture
    {8.0F, 24.0F},  // lean
    {8.0F, 24.0F},  // sit_on_step
    {4.0F, 14.0F},  // carry
    {4.0F, 14.0F},  // hold_up
    {4.0F, 14.0F},  // hold_phone
    {4.0F, 14.0F},  // lead
    {4.0F, 14.0F},  // led
    {4.0F, 14.0F},  // push
    {4.0F, 14.0F},  // stick
    {4.0F, 14.0F},  // other
};
static_assert(std::size(stays) == role_count + 1);

constexpr float share_acting_at_first = 0.3F;

Role resting_role(Habit habit) {
  switch (habit) {
    case Habit::stroll:
    case Habit::march:
    case Habit::accompany:
      return walk;
    case Habit::sit:
    case Habit::rest:
      return sit;
    case Habit::lean:
      return lean;
    case Habit::sit_low:
      return sit_on_step;
    case Habit::photograph:
      return take_picture;
    case Habit::train:
      return jog;
    default:
      return stand;
  }
}

}  // namespace

std::span<const Transition> transitions() { return all_transitions; }

Stay stay_in(Role role) { return stays[index_of(role)]; }

Role first_role(Habit habit, const CharacterRoles& character, Random& whim, HeldThing held) {
  Role rest = resting_role(habit);
  if (!is_gait(rest) && !character.playable(rest)) rest = stand;
  if (!character.playable(rest)) return Role::other;
  const bool acts = !is_gait(rest) && whim.chance(share_acting_at_first);
  return acts ? next_role(habit, rest, character, whim, held) : rest;
}

Role next_role(Habit habit, Role from, const CharacterRoles& character, Random& whim, HeldThing held) {
  const auto is_open = [&](const Transition& transition) {
    return transition.habit == habit && transition.from == from && allows_role(held, transition.to) &&
           character.playable(transition.to);
  };
  float total = 0.0F;
  for (const Transition& transition : all_transitions) total += is_open(transition) ? transition.weight : 0.0F;
  float chosen = whim.unit() * total;
  for (const Transition& transition : all_transitions) {
    if (!is_open(transition)) continue;
    if (chosen < transition.weight) return transition.to;
    chosen -= transition.weight;
  }
  return from;
}

}  // namespace throng::app
