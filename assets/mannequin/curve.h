#pragma once

#include <cmath>
#include <numbers>
#include <span>

namespace throng::mannequin {

/// A key of a periodic curve: where in the cycle, in [0, 1), and its value.
struct CurveKey {
  double phase;
  double value;
};

/// Smooth periodic curve through keys of rising phase that never overshoots them (Fritsch and Carlson 1980),
/// so that two equal keys hold still between them.
double periodic_curve(std::span<const CurveKey> keys, double phase);

/// The same through keys of rising phase that are not repeated; beyond the first and the last it holds still.
double open_curve(std::span<const CurveKey> keys, double phase);

/// Cubic through two values with given slopes; `t` runs from 0 to 1.
double hermite(double from, double from_slope, double to, double to_slope, double t);

/// A whole number of waves per cycle, its peak at `peak`.
inline double wave(double phase, double peak = 0, double waves = 1) {
  return std::cos(2 * std::numbers::pi * waves * (phase - peak));
}

}  // namespace throng::mannequin
