#pragma once

#include <optional>
#include <span>

#include "engine/anim/asset/keyframe_stream_clip.h"
#include "engine/anim/base/units.h"

namespace throng::anim {

inline constexpr double highest_sample_rate = 120.0;

/// Times first + n / rate, n = 0, 1, ...
struct KeyGrid {
  Ticks first = 0;
  double rate = 0.0;  ///< Hz, 1 to highest_sample_rate

  Ticks step() const { return to_ticks(1.0 / rate); }
};

/// The coarsest grid of 1 to 120 Hz on which all `times` (ascending, at least one) lie: a whole number of hertz if
/// there is one, else what divides all their distances. Forgives the rounding of float seconds. Nothing if there is
/// none.
std::optional<KeyGrid> find_grid(std::span<const Ticks> times);

/// Key times of all tracks that move, ascending, each once.
std::vector<Ticks> key_times(const StateClip& clip);

}  // namespace throng::anim
