#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "app/character/roles.h"

namespace throng::app {

/// The thing that an agent has in its hands.
enum class HeldThing : std::uint8_t {
  nothing,
  bag,  ///< a handbag, a tote, a shopping bag
  briefcase,
  umbrella,
  phone,
  cup,
  stick,
  balloon,
  flag,
  camera,
  child,     ///< the hand of a child
  grown_up,  ///< the hand of a grown-up, who holds a child
  pushchair
};
inline constexpr std::size_t held_count = 13;

/// Returns the thing that a part of this name is in a hand; nothing for other names.
HeldThing held_named(std::string_view part);

/// Returns the role whose clip an arm plays while it holds the thing; nothing where no arm does.
std::optional<Role> arm_of(HeldThing held);
/// Returns whether the arm's clip lies over the body's clip in a role. It does not where the hand has another way to
/// hold the thing, or puts it away.
bool arm_lies_over(HeldThing held, Role role);
/// Returns whether the thing is in the hand in a role, or else is put away.
bool is_drawn_in_role(HeldThing held, Role role);
/// Returns whether an agent that holds the thing may go over to a role.
bool allows_role(HeldThing held, Role role);

}  // namespace throng::app
