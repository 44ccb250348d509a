#include "app/character/held.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

namespace throng::app {
namespace {

using enum anim::ClipRole;

constexpr std::array<std::pair<std::string_view, HeldThing>, 13> held_names{{{"handbag", HeldThing::bag},
                                                                             {"tote", HeldThing::bag},
                                                                             {"shopping_bag", HeldThing::bag},
                                                                             {"bag", HeldThing::bag},
                                                                             {"briefcase", HeldThing::briefcase},
                                                                             {"umbrella", HeldThing::umbrella},
                                                                             {"phone", HeldThing::phone},
                                                                             {"cup", HeldThing::cup},
                                                                             {"stick", HeldThing::stick},
                                                                             {"balloon", HeldThing::balloon},
                                                                             {"flag", HeldThing::flag},
                                                                             {"camera", HeldThing::camera},
                                                                             {"pushchair", HeldThing::pushchair}}};

/// The role whose clip an arm plays while it holds each thing, in the order of the things.
constexpr std::array<std::optional<Role>, held_count> arm_roles{
    std::nullopt, carry, carry, hold_up, hold_phone, drink, stick, hold_up, hold_up, take_picture, lead, led, push};

constexpr bool is_one_of(Role role, std::initializer_list<Role> roles) {
  return std::find(roles.begin(), roles.end(), role) != roles.end();
}

constexpr bool takes_the_right_hand(HeldThing held) { return held != HeldThing::nothing && held != HeldThing::child; }

bool is_of_whole_body(Role role) { return is_one_of(role, {phone, call, drink, take_picture}); }

}  // namespace

HeldThing held_named(std::string_view part) {
  const auto* const found = std::ranges::find(held_names, part, &std::pair<std::string_view, HeldThing>::first);
  return found == held_names.end() ? HeldThing::nothing : found->second;
}

std::optional<Role> arm_of(HeldThing held) { return arm_roles.at(static_cast<std::size_t>(held)); }

bool arm_lies_over(HeldThing held, Role role) {
  if (held == HeldThing::nothing || is_of_whole_body(role)) return false;
  const bool is_light = held == HeldThing::umbrella || held == HeldThing::balloon || held == HeldThing::phone;
  if (role == sit || role == sit_on_step) return is_light;
  if (role == lean) return is_light || held == HeldThing::bag || held == HeldThing::briefcase;
  if (held == HeldThing::flag || held == HeldThing::balloon) return !is_one_of(role, {wave, cheer});
  return true;
}

bool is_drawn_in_role(HeldThing held, Role role) {
  if (held == HeldThing::nothing) return false;
  if (role == phone || role == call) return held == HeldThing::phone;
  if (role == drink) return held == HeldThing::cup;
  if (role == take_picture) return held == HeldThing::camera;
  return arm_lies_over(held, role) || held == HeldThing::flag || held == HeldThing::balloon;
}

bool allows_role(HeldThing held, Role role) {
  switch (role) {
    case phone:
    case call:
      return held == HeldThing::phone;
    case drink:
      return held == HeldThing::cup;
    case take_picture:
      return held == HeldThing::camera;
    case wave:
    case cheer:
      return !takes_the_right_hand(held) || held == HeldThing::flag || held == HeldThing::balloon;
    case clap:
      return held == HeldThing::nothing;
    case jog:
    case run:
      return !is_one_of(arm_of(held).value_or(carry), {stick, push, lead, led, drink});
    default:
      return true;
  }
}

}  // namespace throng::app
