#include "app/show/figures/sample_counts.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/counting/hot_path_counter.h"

namespace throng::app::sample_counts_test {
namespace {

constexpr double parts[] = {0.0, 0.01, 0.25, 0.5, 0.9, 0.99, 0.999, 1.0};

/// Times of frames that differ as those of runs do: most are alike, few are long. The same in every run.
class FrameTimes {
 public:
  double next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    const double unit = static_cast<double>(state_ >> 11U) * 0x1p-53;
    return 0.4 + unit * unit * 8.0 + (unit > 0.995 ? 900.0 * unit : 0.0);
  }

 private:
  std::uint64_t state_ = 1;
};

SampleCounts counted(const std::vector<double>& values) {
  SampleCounts counts;
  for (const double value : values) counts.add(value);
  return counts;
}

std::vector<double> frame_times(std::size_t count) {
  FrameTimes times;
  std::vector<double> values(count);
  std::ranges::generate(values, [&] { return times.next(); });
  return values;
}

TEST(SampleCounts, OfNothingAreZero) {
  const SampleCounts none;
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.quantile(0.5), 0.0);
  EXPECT_EQ(none.mean(), 0.0);
  EXPECT_EQ(none.most(), 0.0);
}

TEST(SampleCounts, AreExactAsLongAsThereAreFew) {
  const std::vector<double> values = frame_times(SampleCounts::exact_samples);
  const SampleCounts counts = counted(values);
  for (const double part : parts) EXPECT_EQ(counts.quantile(part), nearest_rank(values, part)) << part;
}

TEST(SampleCounts, AreWithinTheirErrorOnceThereAreMany) {
  const std::vector<double> values = frame_times(SampleCounts::exact_samples * 5);
  const SampleCounts counts = counted(values);
  for (const double part : parts) {
    const double exact = nearest_rank(values, part);
    EXPECT_NEAR(counts.quantile(part), exact, exact * SampleCounts::largest_error) << part;
  }
  EXPECT_EQ(counts.most(), *std::ranges::max_element(values));
}

// From a nanosecond to days, at the ends of steps too.
TEST(SampleCounts, AreWithinTheirErrorAtEveryMagnitude) {
  for (double magnitude = SampleCounts::least_value; magnitude < 1e8; magnitude *= 2.0) {
    for (const double place : {1.0, 1.00390625, 1.0156249, 1.015625, 1.5, 1.9999999}) {
      const SampleCounts counts = counted(std::vector<double>(SampleCounts::exact_samples + 1, magnitude * place));
      EXPECT_NEAR(counts.quantile(0.5), magnitude * place, magnitude * place * SampleCounts::largest_error);
    }
  }
}

TEST(SampleCounts, CountWhatIsTooSmallAsNothingAndWhatIsTooLargeAsLarge) {
  std::vector<double> values(SampleCounts::exact_samples + 1, 0.0);
  EXPECT_EQ(counted(values).quantile(0.99), 0.0);
  values.assign(values.size(), 1e300);
  EXPECT_GT(counted(values).quantile(0.5), 1e9);
}

TEST(SampleCounts, OfTenMillionFramesTakeNoMoreMemoryThanOfNone) {
  SampleCounts counts;
  FrameTimes times;
  double sum = 0.0, most = 0.0;
  const HotPathCounts before = hot_path_counts();
  for (int frame = 0; frame < 10'000'000; ++frame) {
    const double time = times.next();
    sum += time;
    most = std::max(most, time);
    counts.add(time);
  }
  EXPECT_EQ((hot_path_counts() - before).allocations, 0U);
  EXPECT_EQ(counts.count(), 10'000'000U);
  EXPECT_EQ(counts.mean(), sum / 1e7);
  EXPECT_EQ(counts.most(), most);
  const double exact_median = 0.4 + 0.25 * 8.0;  // of the distribution
  EXPECT_NEAR(counts.quantile(0.5), exact_median, exact_median * (SampleCounts::largest_error + 0.002));
}

}  // namespace
}  // namespace throng::app::sample_counts_test
