#pragma once

#include <cmath>
#include <cstdint>

namespace throng::anim {

/// Counts time in integers, since sums of floats drift. 705,600,000 ticks a second divide evenly by every common frame
/// rate and sample rate (24, 25, 30, 48, 50, 60, 90, 100, 120 Hz; 44.1, 48, 96 kHz).
using Ticks = std::int64_t;

inline constexpr Ticks ticks_per_second = 705'600'000;

/// Counts a player's position in 1/65536 ticks, so that speed times time is exact: the position does not depend on how
/// the time was cut into steps. 64 bits hold 55 hours of a clip.
using FineTicks = std::int64_t;

inline constexpr FineTicks fine_ticks_per_tick = 65536;

inline Ticks to_ticks(double seconds) { return std::llround(seconds * static_cast<double>(ticks_per_second)); }
inline double to_seconds(Ticks ticks) { return static_cast<double>(ticks) / static_cast<double>(ticks_per_second); }

}  // namespace throng::anim
