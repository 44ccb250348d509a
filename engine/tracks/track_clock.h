#pragma once

#include <algorithm>
#include <cmath>

namespace throng {

/// The time of a recorded crowd, which can be moved, turned round and repeated. Seconds are of the file's clock.
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

/// Returns the clock at another time, as near to it as its part goes.
inline TrackClock gone_to(TrackClock clock, double seconds) {
  clock.seconds = std::clamp(seconds, clock.first, clock.last);
  return clock;
}

/// Returns the clock with another part, whose ends may come in either order, at the nearest time in it.
inline TrackClock with_part(TrackClock clock, double one_end, double other_end) {
  clock.first = std::min(one_end, other_end);
  clock.last = std::max(one_end, other_end);
  return gone_to(clock, clock.seconds);
}

/// Returns whether the clock goes no further.
inline bool has_ended(const TrackClock& clock) {
  return !clock.repeats && (clock.rate < 0.0 ? clock.seconds <= clock.first : clock.seconds >= clock.last);
}

/// Returns the clock going on, or backwards; from the other end of its part where it could go no further.
inline TrackClock playing(TrackClock clock, bool backwards) {
  clock.rate = backwards ? -std::abs(clock.rate) : std::abs(clock.rate);
  if (has_ended(clock)) clock.seconds = backwards ? clock.last : clock.first;
  return clock;
}

/// Returns the time of the row `steps` rows further, or back below 0, where a row comes each `row` seconds from `first`
/// on. Between two rows, the next row is one further.
inline double row_from(double seconds, double first, double row, int steps) {
  constexpr double nearly = 1e-6;  // of a row
  const double place = (seconds - first) / row;
  const double from = steps < 0 ? std::ceil(place - nearly) : std::floor(place + nearly);
  return first + row * (from + steps);
}

}  // namespace throng
