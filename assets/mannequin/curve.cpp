#include "assets/mannequin/curve.h"

#include <cassert>
#include <cstddef>

namespace throng::mannequin {
namespace {

/// Key `i` of the endlessly repeated curve.
CurveKey repeated(std::span<const CurveKey> keys, std::ptrdiff_t i) {
  const auto count = static_cast<std::ptrdiff_t>(keys.size());
  const std::ptrdiff_t cycle = i >= 0 ? i / count : -((count - 1 - i) / count);
  const CurveKey key = keys[static_cast<std::size_t>(i - cycle * count)];
  return {key.phase + static_cast<double>(cycle), key.value};
}

/// Harmonic mean of the slopes on both sides; zero at extremes.
double slope_at(std::span<const CurveKey> keys, std::ptrdiff_t i) {
  const CurveKey before = repeated(keys, i - 1);
  const CurveKey here = repeated(keys, i);
  const CurveKey after = repeated(keys, i + 1);
  const double left = (here.value - before.value) / (here.phase - before.phase);
  const double right = (after.value - here.value) / (after.phase - here.phase);
  return left * right <= 0 ? 0 : 2 * left * right / (left + right);
}

}  // namespace

double hermite(double from, double from_slope, double to, double to_slope, double t) {
  const double u = 1 - t;
  return u * u * (1 + 2 * t) * from + u * u * t * from_slope + t * t * (3 - 2 * t) * to - t * t * u * to_slope;
}

double periodic_curve(std::span<const CurveKey> keys, double phase) {
  assert(!keys.empty());
  const double wrapped = phase - std::floor(phase);
  std::ptrdiff_t i = -1;
  while (repeated(keys, i + 1).phase <= wrapped) ++i;
  const CurveKey from = repeated(keys, i);
  const CurveKey to = repeated(keys, i + 1);
  const double span = to.phase - from.phase;
  return hermite(from.value, slope_at(keys, i) * span, to.value, slope_at(keys, i + 1) * span,
                 (wrapped - from.phase) / span);
}

}  // namespace throng::mannequin
