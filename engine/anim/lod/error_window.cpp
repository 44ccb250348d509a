#include "engine/anim/lod/error_window.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace throng::anim {

ErrorCounts::Step ErrorCounts::step_of(float pixels) {
  int exponent = 0;
  const float fraction = std::frexp(pixels, &exponent);  // 0.5 to 1
  if (pixels <= 0.0F || exponent <= least_exponent) return 0;
  if (exponent > most_exponent) return step_count - 1;
  const int within = static_cast<int>((fraction - 0.5F) * 2.0F * steps_an_octave);
  return static_cast<Step>(1 + (exponent - 1 - least_exponent) * steps_an_octave + within);
}

float ErrorCounts::percentile(double part) const {
  if (total_ == 0) return 0.0F;
  return at_rank(static_cast<std::uint64_t>(std::ceil(part * static_cast<double>(total_))));
}

QuantileInterval ErrorCounts::interval(double part) const {
  const QuantileRanks ranks = quantile_ranks(total_, part);
  return {.low = ranks.low == 0 ? 0.0F : at_rank(ranks.low),
          .high = ranks.high ? std::optional(at_rank(*ranks.high)) : std::nullopt};
}

float ErrorCounts::at_rank(std::uint64_t rank) const {
  std::uint64_t below = 0;
  std::size_t step = 0;
  while (step + 1 < step_count && (below += counts_[step]) < std::max<std::uint64_t>(rank, 1)) ++step;
  if (step == 0) return 0.0F;
  const auto octave = static_cast<int>((step - 1) / steps_an_octave);
  const auto upper_end = static_cast<float>((step - 1) % steps_an_octave + 1) / steps_an_octave;
  return std::ldexp(1.0F + upper_end, octave + least_exponent);
}

void ErrorWindow::reserve(std::size_t samples_a_frame) {
  for (Frame& frame : ring_) frame.steps.reserve(samples_a_frame);
}

void ErrorWindow::forget(Frame& frame) {
  for (const ErrorCounts::Step step : frame.steps) counts_.remove(step);
  frame.steps.clear();
  --held_;
}

void ErrorWindow::begin_anew() {
  while (held_ > 0) forget(ago(held_ - 1));
}

void ErrorWindow::begin_frame() {
  const auto has_enough_without = [this](const Frame& frame) {
    return counts_.total() - frame.steps.size() >= ErrorFigures::samples_for_p99;
  };
  while (held_ == most_frames || (held_ >= frames && has_enough_without(ago(held_ - 1)))) forget(ago(held_ - 1));
  newest_ = (newest_ + 1) % most_frames;
  ++held_;
  ++all_frames_;
  ring_[newest_].max = ring_[newest_].pop_max = 0.0F;
}

void ErrorWindow::add(const ErrorSample& sample) {
  Frame& frame = ring_[newest_];
  const ErrorCounts::Step step = ErrorCounts::step_of(sample.error);
  frame.steps.push_back(step);
  counts_.add(step);
  all_counts_.add(step);
  frame.max = std::max(frame.max, sample.error);
  frame.pop_max = std::max(frame.pop_max, sample.pop.value_or(0.0F));
  all_max_ = std::max(all_max_, sample.error);
  all_pop_max_ = std::max(all_pop_max_, sample.pop.value_or(0.0F));
}

namespace {

ErrorFigures figures_of(const ErrorCounts& counts, std::uint64_t frames, float max, float pop_max) {
  constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
  return {.p50 = counts.percentile(0.5),
          .p99 = counts.percentile(0.99),
          .max = max,
          .pop_max = pop_max,
          .samples = static_cast<std::uint32_t>(std::min(counts.total(), most)),
          .frames = static_cast<std::uint32_t>(std::min(frames, most))};
}

}  // namespace

ErrorFigures ErrorWindow::figures() const {
  float max = 0.0F, pop_max = 0.0F;
  for (std::size_t i = 0; i < std::min(held_, frames); ++i) {
    const Frame& frame = ring_[(newest_ + most_frames - i) % most_frames];
    max = std::max(max, frame.max);
    pop_max = std::max(pop_max, frame.pop_max);
  }
  return figures_of(counts_, held_, max, pop_max);
}

ErrorFigures ErrorWindow::since_start() const { return figures_of(all_counts_, all_frames_, all_max_, all_pop_max_); }

}  // namespace throng::anim
