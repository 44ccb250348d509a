#pragma once

#include <array>
#include <cstddef>

#include "engine/anim/agent/cross_fade_channel.h"

namespace throng::anim {

/// One-shots that follow one another over a pose, as entities. Each `in` eases to the player of its shot, and `out`
/// eases back to the pose below.
///
///     below ──── in ──── in ──── out
///               /       /       /
///         player  player   below
struct OneShotTree {
  static constexpr std::size_t max_shots = 4;

  struct Shot {
    Ticks begins;    ///< by the clock
    Ticks ends;      ///< by the clock
    Ticks faded_in;  ///< by the clock; from then on nothing below it is seen
    Handle player;
    Handle in;  ///< invalid once the shot has faded in, or if it was not to
  };

  std::array<Shot, max_shots> shots{};
  std::size_t count = 0;
  Handle out;

  bool empty() const { return count == 0; }
  const Shot& last() const { return shots[count - 1]; }
  /// Returns when the next shot has faded in, or never.
  Ticks next_faded_in() const;

  /// Joins the entities over a pose, or over nothing if the handle is invalid.
  void join(const EntityBuilder& build, Handle below) const;
  /// Returns the result over a pose, or over nothing.
  Handle root(bool has_below) const;
  /// Removes the shots that are no longer seen, and fades that are over. Returns whether there were any.
  bool drop_covered(const EntityBuilder& build);
  void destroy(const EntityBuilder& build);
  void visit_handles(const std::function<void(Handle&)>& visit);
};

}  // namespace throng::anim
