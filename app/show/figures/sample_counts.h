#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace throng::app {

/// Returns the value at the nearest rank, `part` of the way from the least (0) to the most (1); 0 where there are none.
double nearest_rank(std::vector<double> values, double part);

/// Takes one sample a frame, such as a time in milliseconds, and stays as large as it is made, a hundred kilobytes.
/// Count, mean and most are exact, as are quantiles of up to `exact_samples` samples. Quantiles of more samples come
/// from counts in steps of a 64th of an octave, and are off by at most `largest_error` of the exact value, or by
/// `least_value` where it is less than that.
class SampleCounts {
 public:
  static constexpr std::size_t exact_samples = 10'000;
  static constexpr double largest_error = 1.0 / 128;  ///< 0.8%
  static constexpr double least_value = 0x1p-20;      ///< a nanosecond, of milliseconds; less counts as 0

  SampleCounts();

  /// Adds a finite value, 0 or more. Never allocates.
  void add(double value);

  bool empty() const { return count_ == 0; }
  std::uint64_t count() const { return count_; }
  /// Returns 0 without samples, as the next functions do.
  double mean() const;
  double most() const { return most_; }
  /// Returns the value at the nearest rank.
  double quantile(double part) const;

 private:
  static constexpr int least_exponent = -20, most_exponent = 30;  // powers of 2; of milliseconds, to twelve days
  static constexpr int steps_an_octave = 64;
  static constexpr std::size_t step_count = (most_exponent - least_exponent) * steps_an_octave + 1;

  static std::size_t step_of(double value);
  static double middle_of(std::size_t step);

  std::array<std::uint64_t, step_count> counts_{};  // the first step is 0
  std::vector<double> first_;                       // the first exact_samples samples
  std::uint64_t count_ = 0;
  double sum_ = 0.0, most_ = 0.0;
};

}  // namespace throng::app
