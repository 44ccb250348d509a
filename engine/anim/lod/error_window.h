#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/anim/lod/quantile_interval.h"

/// Collects how far shown poses are off, in pixels on screen, over a crowd and some time.
namespace throng::anim {

/// Errors of measured agents. All figures are 0 where no agent was measured.
struct ErrorFigures {
  /// The samples below which chance decides a ninety-ninth percentile, so that nothing is learned from it.
  static constexpr std::uint32_t samples_for_p99 = 1000;

  float p50 = 0.0F;
  float p99 = 0.0F;
  float max = 0.0F;
  float pop_max = 0.0F;  ///< the largest change of an error from one frame to the next
  std::uint32_t samples = 0;
  std::uint32_t frames = 0;  ///< that the samples of the percentiles come from

  bool p99_is_known() const { return samples >= samples_for_p99; }
};

/// Where the percentiles of all agents that could have been measured lie, with a confidence of 95%
/// (quantile_interval.h).
struct ErrorIntervals {
  QuantileInterval p50, p99;
};

/// The error of one agent in one frame.
struct ErrorSample {
  float error = 0.0F;        ///< pixels, 0 or more
  std::optional<float> pop;  ///< pixels; none if it was not measured in the frame before
};

/// Counts errors in steps of 2%, so that a percentile of any number of samples takes the same time. A percentile is the
/// upper end of its step, so it is never too small. Errors below a 256th of a pixel count as 0.
class ErrorCounts {
 public:
  using Step = std::uint16_t;

  static Step step_of(float pixels);

  void add(Step step) {
    ++counts_[step];
    ++total_;
  }
  void remove(Step step) {
    --counts_[step];
    --total_;
  }
  /// Returns the error that `part` of the samples, 0 to 1, do not exceed; 0 without samples.
  float percentile(double part) const;
  /// Returns the interval in which that percentile lies; its ends are upper ends of steps too.
  QuantileInterval interval(double part) const;
  std::uint64_t total() const { return total_; }

 private:
  float at_rank(std::uint64_t rank) const;

  static constexpr int least_exponent = -8, most_exponent = 14;  // powers of 2
  static constexpr int steps_an_octave = 32;
  static constexpr std::size_t step_count = (most_exponent - least_exponent) * steps_an_octave + 1;

  std::array<std::uint64_t, step_count> counts_{};  // a crowd adds 2^32 samples in two hours
  std::uint64_t total_ = 0;
};

/// Keeps the errors of the last 60 frames, and counts all errors since the start. Where the last 60 frames have too few
/// samples for a ninety-ninth percentile, percentiles look further back, up to 600 frames.
class ErrorWindow {
 public:
  static constexpr std::size_t frames = 60;
  static constexpr std::size_t most_frames = 600;

  /// Makes room for so many samples a frame, so that add() does not allocate.
  void reserve(std::size_t samples_a_frame);
  /// Forgets all frames so far; the errors since the start still count.
  void begin_anew();
  /// Begins a frame and forgets the oldest frames that are not needed.
  void begin_frame();
  /// Adds a sample to the frame that was begun last.
  void add(const ErrorSample& sample);

  ErrorFigures figures() const;
  ErrorIntervals intervals() const { return intervals_of(counts_); }
  ErrorFigures since_start() const;
  ErrorIntervals intervals_since_start() const { return intervals_of(all_counts_); }
  /// Returns the largest pop of the frame that was begun last.
  float newest_pop() const { return ring_[newest_].pop_max; }

 private:
  struct Frame {
    std::vector<ErrorCounts::Step> steps;
    float max = 0.0F, pop_max = 0.0F;
  };

  static ErrorIntervals intervals_of(const ErrorCounts& counts) {
    return {.p50 = counts.interval(0.5), .p99 = counts.interval(0.99)};
  }
  Frame& ago(std::size_t frames_ago) { return ring_[(newest_ + most_frames - frames_ago) % most_frames]; }
  void forget(Frame& frame);

  std::array<Frame, most_frames> ring_;
  std::size_t newest_ = 0;
  std::size_t held_ = 0;  // frames whose samples count
  ErrorCounts counts_, all_counts_;
  std::uint64_t all_frames_ = 0;
  float all_max_ = 0.0F, all_pop_max_ = 0.0F;
};

}  // namespace throng::anim
