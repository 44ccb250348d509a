#include "app/character/held.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

namespace throng::app {
namespace {

using enum anim::ClipRole;

constexpr std::array<std::pair<std::string_view, Held>, 13> held_names{{{"handbag", Held::bag},
                                                                        {"tote", Held::bag},
                                                                        {"shopping_bag", Held::bag},
                                                                        {"bag", Held::bag},
                                                                        {"briefcase", Held::briefcase},
                                                                        {"umbrella", Held::umbrella},
                                                                        {"phone", Held::phone},
                                                                        {"cup", Held::cup},
                                                                        {"stick", Held::stick},
                                                                        {"balloon", Held::balloon},
                                                                        {"flag", Held::flag},
                                                                        {"camera", Held::camera},
                                                                        {"pushchair", Held::pushchair}}};

constexpr bool is_one_of(Role role, std::initializer_list<Role> roles) {
  return std::find(roles.begin(), roles.end(), role) != roles.end();
}

constexpr bool takes_the_right_hand(Held held) { return held != Held::nothing && held != Held::child; }

bool is_of_whole_body(Role role) { return is_one_of(role, {phone, call, drink, take_picture}); }

}  // namespace

Held held_named(std::string_view part) {
  const auto* const found = std::ranges::find(held_names, part, &std::pair<std::string_view, Held>::first);
  return found == held_names.end() ? Held::nothing : found->second;
}

std::optional<Role> arm_of(Held held) {
  switch (held) {
    case Held::bag:
    case Held::briefcase:
      return carry;
    case Held::umbrella:
    case Held::balloon:
    case Held::flag:
      return hold_up;
    case Held::phone:
      return hold_phone;
    case Held::cup:
      return drink;
    case Held::camera:
      return take_picture;
    case Held::stick:
      return stick;
    case Held::child:
      return lead;
    case Held::grown_up:
      return led;
    case Held::pushchair:
      return push;
    default:
      return std::nullopt;
  }
}

bool arm_lies_over(Held held, Role role) {
  if (held == Held::nothing || is_of_whole_body(role)) return false;
  const bool is_light = held == Held::umbrella || held == Held::balloon || held == Held::phone;
  if (role == sit || role == sit_on_step) return is_light;
  if (role == lean) return is_light || held == Held::bag || held == Held::briefcase;
  if (held == Held::flag || held == Held::balloon) return !is_one_of(role, {wave, cheer});
  return true;
}

bool is_in_hand(Held held, Role role) {
  if (held == Held::nothing) return false;
  if (role == phone || role == call) return held == Held::phone;
  if (role == drink) return held == Held::cup;
  if (role == take_picture) return held == Held::camera;
  return arm_lies_over(held, role) || held == Held::flag || held == Held::balloon;
}

bool can_do(Held held, Role role) {
  switch (role) {
    case phone:
    case call:
      return held == Held::phone;
    case drink:
      return held == Held::cup;
    case take_picture:
      return held == Held::camera;
    case wave:
    case cheer:
      return !takes_the_right_hand(held) || held == Held::flag || held == Held::balloon;
    case clap:
      return held == Held::nothing;
    case jog:
    case run:
      return !is_one_of(arm_of(held).value_or(carry), {stick, push, lead, led, drink});
    default:
      return true;
  }
}

}  // namespace throng::app
