#include "engine/anim/bake/grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace throng::anim {

namespace {

/// Returns the seconds by which a key may miss its place: exporters write decimals, and files hold 32-bit floats.
double tolerance(double seconds) { return 1e-5 + 4e-7 * seconds; }

/// Returns the seconds of each key since the first.
std::vector<double> distances_from_first(std::span<const Ticks> times) {
  std::vector<double> distances;
  for (const Ticks time : times) distances.push_back(to_seconds(time - times.front()));
  return distances;
}

bool all_on_grid(std::span<const double> distances, double first, double rate) {
  return std::ranges::all_of(distances, [&](double distance) {
    return std::abs(distance - std::round(distance * rate) / rate) <= tolerance(first + distance);
  });
}

/// Runs Euclid's algorithm on measured lengths. A rest up to `nothing` counts as 0.
double common_divisor(double a, double b, double nothing) {
  while (b > nothing) {
    const double rest = std::abs(a - std::round(a / b) * b);
    a = b;
    b = rest;
  }
  return a;
}

/// Returns the rate whose whole steps fit all distances, or 0. Longer distances tell the step more exactly.
double divisor_rate(std::span<const double> distances, double first) {
  const double nothing = 4.0 * tolerance(first + distances.back());
  double step = 0.0;
  for (const double distance : distances) {
    step = common_divisor(distance, step, nothing);
    if (distance > nothing) step = distance / std::round(distance / step);
    if (step > 0.0 && step * highest_sample_rate < 0.5) return 0.0;
  }
  return step > 0.0 ? 1.0 / step : 0.0;
}

}  // namespace

std::optional<KeyGrid> find_grid(std::span<const Ticks> times, double start) {
  assert(!times.empty());
  const std::vector<double> distances = distances_from_first(times);
  const double first = start + to_seconds(times.front());
  for (int hertz = 1; hertz <= static_cast<int>(highest_sample_rate); ++hertz) {
    if (all_on_grid(distances, first, hertz)) return KeyGrid{times.front(), static_cast<double>(hertz)};
  }
  double rate = divisor_rate(distances, first);
  if (rate <= 0.0) return std::nullopt;
  rate *= std::max(1.0, std::ceil(1.0 / rate));
  if (rate > highest_sample_rate || !all_on_grid(distances, first, rate)) return std::nullopt;
  return KeyGrid{times.front(), rate};
}

std::vector<Ticks> key_times(const StateClip& clip) {
  std::vector<Ticks> times;
  for (const StateTrack& track : clip.tracks) {
    for (const StateKey& key : track.keys) times.push_back(key.time);
  }
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace throng::anim
