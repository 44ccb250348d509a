#pragma once

#include <cstdint>
#include <optional>

namespace throng::anim {

/// The places of two samples in ascending order, counted from 1, between which a quantile lies.
struct QuantileRanks {
  std::uint64_t low = 0;                   ///< 0: no sample is surely below the quantile
  std::optional<std::uint64_t> high = {};  ///< nothing: no sample is surely above the quantile
};

/// The two values between which a quantile lies.
struct QuantileInterval {
  float low = 0.0F;
  std::optional<float> high = {};  ///< nothing: there are too few samples to say
};

/// Returns the ranks between which the quantile of `part`, above 0 and below 1, of the samples' distribution lies with
/// at least `confidence`, above 0 and below 1. Each side is missed with at most half of the rest. The number
/// of samples below the quantile has a binomial distribution, whatever the distribution of the samples. Samples that
/// depend on each other make the true confidence smaller.
///
/// The ranks are exact where the variance of that number is below 400, and above it within one rank, by the normal
/// distribution. (David and Nagaraja, Order Statistics, 3rd edition, section 7.1.)
QuantileRanks quantile_ranks(std::uint64_t samples, double part, double confidence = 0.95);

}  // namespace throng::anim
