#pragma once

#include <algorithm>
#include <cmath>

namespace throng::app {

/// The time of a recorded crowd, which one can move, turn round and repeat. Seconds are those of the file's clock.
struct TrackClock {
  double seconds = 0.0;
  double first = 0.0, last = 0.0;  ///< the part that is played; last is not before first
  double rate = 1.0;               ///< seconds of the file a second of the crowd; below 0: backwards
  bool repeats = false;            ///< at its end the part begins anew; else it stays there
  float stands = 0.0F;             ///< 1: people stand in the middle of their way, for no more rows come

  friend bool operator==(const TrackClock&, const TrackClock&) = default;
};

/// Moves the clock on by `seconds` of the crowd, within its part.
inline void advance(TrackClock& clock, double seconds) {
  const double next = clock.seconds + seconds * clock.rate, length = clock.last - clock.first;
  if (!clock.repeats || length <= 0.0) {
    clock.seconds = std::clamp(next, clock.first, clock.last);
  } else {
    const double into = std::fmod(next - clock.first, length);
    clock.seconds = clock.first + (into < 0.0 ? into + length : into);
  }
}

}  // namespace throng::app
