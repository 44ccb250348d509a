#pragma once

#include <concepts>
#include <cstdint>

#include "throng/ticks.h"

namespace throng::anim {

using throng::to_ticks;  // beside the one below

/// Counts a player's position in 1/65536 ticks, so that speed times time is exact: the position does not depend on how
/// the time was cut into steps. 64 bits hold 55 hours at a clip's own speed, which are counted from the loop in which a
/// player stands. These are bare integers, which no function that wants Ticks takes, and which no Ticks become by
/// themselves.
using FineTicks = std::int64_t;

/// Leads from ticks to fine ticks by a product, and back by a quotient, which is rounded towards zero.
struct FineTicksPerTick {
  static constexpr std::int64_t count() { return 65536; }
  friend constexpr FineTicks operator*(Ticks ticks, FineTicksPerTick) { return ticks.count() * count(); }
  friend constexpr Ticks operator/(FineTicks position, FineTicksPerTick) { return Ticks{position / count()}; }
};

inline constexpr FineTicksPerTick fine_ticks_per_tick;

/// A position in fine ticks is no number of seconds.
template <std::same_as<FineTicks> Position>
Ticks to_ticks(Position) = delete;

}  // namespace throng::anim
