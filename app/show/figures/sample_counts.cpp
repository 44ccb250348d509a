#include "app/show/figures/sample_counts.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace throng::app {
namespace {

std::uint64_t rank_of(double part, std::uint64_t count) {
  return static_cast<std::uint64_t>(std::llround(part * static_cast<double>(count - 1)));
}

}  // namespace

double nearest_rank(std::vector<double> values, double part) {
  if (values.empty()) return 0.0;
  const auto rank = static_cast<std::ptrdiff_t>(rank_of(part, values.size()));
  std::ranges::nth_element(values, values.begin() + rank);
  return values[static_cast<std::size_t>(rank)];
}

SampleCounts::SampleCounts() { first_.reserve(exact_samples); }

std::size_t SampleCounts::step_of(double value) {
  if (value < least_value) return 0;
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);  // 0.5 to 1
  if (exponent > most_exponent) return step_count - 1;
  const int within = static_cast<int>((fraction - 0.5) * 2.0 * steps_an_octave);
  return static_cast<std::size_t>(1 + (exponent - 1 - least_exponent) * steps_an_octave + within);
}

double SampleCounts::middle_of(std::size_t step) {
  if (step == 0) return 0.0;
  const auto octave = static_cast<int>((step - 1) / steps_an_octave);
  const double within = (static_cast<double>((step - 1) % steps_an_octave) + 0.5) / steps_an_octave;
  return std::ldexp(1.0 + within, octave + least_exponent);
}

void SampleCounts::add(double value) {
  assert(std::isfinite(value) && value >= 0.0);
  if (count_ < exact_samples) first_.push_back(value);
  ++counts_[step_of(value)];
  ++count_;
  sum_ += value;
  most_ = std::max(most_, value);
}

double SampleCounts::mean() const { return empty() ? 0.0 : sum_ / static_cast<double>(count_); }

double SampleCounts::quantile(double part) const {
  if (count_ <= exact_samples) return nearest_rank(first_, part);
  const std::uint64_t rank = rank_of(part, count_);
  std::uint64_t up_to = counts_[0];
  std::size_t step = 0;
  while (up_to <= rank) up_to += counts_[++step];
  return std::min(middle_of(step), most_);
}

}  // namespace throng::app
