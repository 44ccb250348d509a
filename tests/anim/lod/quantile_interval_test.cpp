// Intervals of confidence for quantiles, against tables of order statistics and against chance itself.

#include "engine/anim/lod/quantile_interval.h"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace throng::anim::quantile_interval_test {
namespace {

void expect_ranks(std::uint64_t samples, double part, std::uint64_t low, std::optional<std::uint64_t> high) {
  const QuantileRanks ranks = quantile_ranks(samples, part);
  EXPECT_EQ(ranks.low, low) << samples << " samples, " << part;
  EXPECT_EQ(ranks.high, high) << samples << " samples, " << part;
}

// The table of nearly every book: David and Nagaraja, Conover, and others.
TEST(QuantileRanks, OfAMedianAreThoseOfTheTables) {
  expect_ranks(6, 0.5, 1, 6);
  expect_ranks(10, 0.5, 2, 9);
  expect_ranks(15, 0.5, 4, 12);
  expect_ranks(20, 0.5, 6, 15);
  expect_ranks(25, 0.5, 8, 18);
  expect_ranks(50, 0.5, 18, 33);
  expect_ranks(100, 0.5, 40, 61);
}

TEST(QuantileRanks, HaveNoEndWhereTooFewSamplesSayWhereItIs) {
  expect_ranks(0, 0.5, 0, {});
  expect_ranks(1, 0.99, 1, {});
  expect_ranks(5, 0.5, 0, {});
  EXPECT_FALSE(quantile_ranks(367, 0.99).high) << "the largest of 367 is below the quantile in more than 2.5%";
  EXPECT_EQ(quantile_ranks(368, 0.99).high, 368U) << "0.99 to the power of 368 is 2.48%";
}

TEST(QuantileRanks, OfOppositeQuantilesMirrorEachOther) {
  for (const std::uint64_t samples : {10U, 400U, 1000U, 100'000U}) {
    const QuantileRanks lower = quantile_ranks(samples, 0.1), upper = quantile_ranks(samples, 0.9);
    EXPECT_EQ(lower.low + upper.high.value_or(samples + 1), samples + 1) << samples;
    EXPECT_EQ(lower.high.value_or(samples + 1) + upper.low, samples + 1) << samples;
  }
}

TEST(QuantileRanks, GetNarrowerTheMoreSamplesThereAre) {
  double before = 1.0;
  for (const std::uint64_t samples : {1000U, 4000U, 40'000U, 41'000U, 1'000'000U}) {
    const QuantileRanks ranks = quantile_ranks(samples, 0.99);
    const double width = static_cast<double>(*ranks.high - ranks.low) / static_cast<double>(samples);
    EXPECT_LT(width, before) << samples;
    EXPECT_LT(ranks.low, 0.99 * static_cast<double>(samples));
    EXPECT_GT(*ranks.high, 0.99 * static_cast<double>(samples));
    before = width;
  }
}

TEST(QuantileRanks, HoldTheQuantileAsOftenAsTheySay) {
  std::mt19937 random(7);
  constexpr int draws = 2000, samples = 600;
  constexpr double quantile = 0.99;  // of numbers from 0 to 1
  const QuantileRanks ranks = quantile_ranks(samples, quantile);
  ASSERT_TRUE(ranks.high);
  int held = 0;
  std::vector<double> values(samples);
  for (int draw = 0; draw < draws; ++draw) {
    for (double& value : values) value = static_cast<double>(random()) / 4294967296.0;
    std::ranges::sort(values);
    held += values[ranks.low - 1] <= quantile && quantile <= values[*ranks.high - 1] ? 1 : 0;
  }
  EXPECT_GE(held, draws * 0.94);
}

}  // namespace
}  // namespace throng::anim::quantile_interval_test
