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
double slope_between(const CurveKey& before, const CurveKey& here, const CurveKey& after) {
  const double left = (here.value - before.value) / (here.phase - before.phase);
  const double right = (after.value - here.value) / (after.phase - here.phase);
  return left * right <= 0 ? 0 : 2 * left * right / (left + right);
}

double slope_at(std::span<const CurveKey> keys, std::ptrdiff_t i) {
  return slope_between(repeated(keys, i - 1), repeated(keys, i), repeated(keys, i + 1));
}

/// At its two ends an open curve goes on as straight as it came.
double open_slope_at(std::span<const CurveKey> keys, std::size_t i) {
  const auto secant = [&](std::size_t from) {
    return (keys[from + 1].value - keys[from].value) / (keys[from + 1].phase - keys[from].phase);
  };
  if (i == 0) return secant(0);
  if (i + 1 == keys.size()) return secant(i - 1);
  return slope_between(keys[i - 1], keys[i], keys[i + 1]);
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

double open_curve(std::span<const CurveKey> keys, double phase) {
  assert(keys.size() > 1);
  if (phase <= keys.front().phase) return keys.front().value;
  if (phase >= keys.back().phase) return keys.back().value;
  std::size_t i = 0;
  while (keys[i + 1].phase <= phase) ++i;
  const double span = keys[i + 1].phase - keys[i].phase;
  return hermite(keys[i].value, open_slope_at(keys, i) * span, keys[i + 1].value, open_slope_at(keys, i + 1) * span,
                 (phase - keys[i].phase) / span);
}

}  // namespace throng::mannequin
