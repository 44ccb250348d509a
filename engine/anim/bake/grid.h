#pragma once

#include <optional>
#include <span>

#include "engine/anim/asset/keyframe_stream_clip.h"
#include "engine/anim/base/units.h"

namespace throng::anim {

inline constexpr double highest_sample_rate = 120.0;

/// The times first + n / rate, n = 0, 1, ...
struct KeyGrid {
  Ticks first{};
  double rate = 0.0;  ///< Hz, 1 to highest_sample_rate

  Ticks step() const { return to_ticks(1.0 / rate); }
};

/// Finds the coarsest grid of 1 to 120 Hz on which all `times` lie (ascending, at least one), or nothing. It has a
/// whole number of hertz if one fits, else the longest step that divides all distances. Forgives the rounding of float
/// seconds, in which the file has its times: `start` is the file's time at time 0, in seconds.
std::optional<KeyGrid> find_grid(std::span<const Ticks> times, double start = 0.0);

/// Returns the key times of all moving tracks, ascending, each once.
std::vector<Ticks> key_times(const StateClip& clip);

}  // namespace throng::anim
