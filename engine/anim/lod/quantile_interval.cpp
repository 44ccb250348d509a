#include "engine/anim/lod/quantile_interval.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace throng::anim {
namespace {

constexpr double most_exact_variance = 400.0;

/// Numbers of samples that one side of a quantile has with small probability at most.
struct Tails {
  std::uint64_t below;  ///< the most with P(number < below) <= tail
  std::uint64_t above;  ///< the least with P(number >= above) <= tail
};

/// Of a binomial distribution. Goes through numbers from 0 on, so `part` is at most a half.
Tails exact_tails(std::uint64_t samples, double part, double tail) {
  const auto count = static_cast<double>(samples);
  const double odds = std::log(part) - std::log1p(-part);
  double logarithm = count * std::log1p(-part);  // of the probability of `number`
  double less = 0.0;                             // P(fewer than `number`)
  Tails tails{0, samples + 1};
  for (std::uint64_t number = 0; number <= samples; ++number) {
    if (less <= tail) tails.below = number;
    if (1.0 - less <= tail) {
      tails.above = number;
      break;
    }
    less += std::exp(logarithm);
    const auto done = static_cast<double>(number);
    logarithm += odds + std::log((count - done) / (done + 1.0));
  }
  return tails;
}

/// Returns the number that a normal variable exceeds with the probability `tail`, below a half, in standard deviations.
double deviations_of(double tail) {
  double low = 0.0, high = 40.0;
  for (int halvings = 0; halvings < 60; ++halvings) {
    const double middle = (low + high) / 2.0;
    (std::erfc(middle / std::numbers::sqrt2) / 2.0 > tail ? low : high) = middle;
  }
  return low;
}

Tails normal_tails(std::uint64_t samples, double part, double variance, double tail) {
  const double mean = static_cast<double>(samples) * part, reach = deviations_of(tail) * std::sqrt(variance);
  return {static_cast<std::uint64_t>(std::max(0.0, std::floor(mean - reach + 0.5))),
          static_cast<std::uint64_t>(std::ceil(mean + reach + 0.5))};
}

}  // namespace

// A quantile has on its smaller side a number of samples that is soon gone through.
QuantileRanks quantile_ranks(std::uint64_t samples, double part, double confidence) {
  assert(part > 0.0 && part < 1.0 && confidence > 0.0 && confidence < 1.0);
  const double tail = (1.0 - confidence) / 2.0, smaller = std::min(part, 1.0 - part);
  const double variance = static_cast<double>(samples) * part * (1.0 - part);
  const Tails tails = variance < most_exact_variance ? exact_tails(samples, smaller, tail)
                                                     : normal_tails(samples, smaller, variance, tail);
  const auto rank = [samples](std::uint64_t number) {
    return number <= samples ? std::optional(number) : std::nullopt;
  };
  if (part <= 0.5) return {tails.below, rank(tails.above)};
  // Counted from the other end.
  const std::uint64_t low = tails.above > samples ? 0 : samples + 1 - tails.above;
  return {low, tails.below == 0 ? std::nullopt : rank(samples + 1 - tails.below)};
}

}  // namespace throng::anim
