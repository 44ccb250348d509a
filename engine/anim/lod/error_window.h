#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

/// Collects how far shown poses are off, in pixels on screen, over a crowd and some time.
namespace throng::anim {

/// Errors of the agents that were measured. All figures are 0 where none was.
struct ErrorFigures {
  /// The samples below which chance decides a ninety-ninth percentile.
  static constexpr std::uint32_t samples_for_p99 = 1000;

  float p50 = 0.0F;
  float p99 = 0.0F;
  float max = 0.0F;
  float pop_max = 0.0F;  ///< the largest change of an error from one frame to the next
  std::uint32_t samples = 0;

  bool p99_is_known() const { return samples >= samples_for_p99; }
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
  std::uint64_t total() const { return total_; }

 private:
  static constexpr int least_exponent = -8, most_exponent = 14;  // powers of 2
  static constexpr int steps_an_octave = 32;
  static constexpr std::size_t step_count = (most_exponent - least_exponent) * steps_an_octave + 1;

  std::array<std::uint64_t, step_count> counts_{};  // a crowd adds 2^32 samples in two hours
  std::uint64_t total_ = 0;
};

/// Keeps the errors of the last 60 frames, and counts those since the start. Where the last 60 frames have too few
/// samples for a ninety-ninth percentile, percentiles look further back, up to 600 frames.
class ErrorWindow {
 public:
  static constexpr std::size_t frames = 60;
  static constexpr std::size_t most_frames = 600;

  /// Makes room for so many samples a frame, so that add() does not allocate.
  void reserve(std::size_t samples_a_frame);
  /// Begins a frame and forgets the oldest ones that are not needed.
  void begin_frame();
  /// Adds a sample to the frame that was begun last.
  void add(const ErrorSample& sample);

  ErrorFigures figures() const;
  ErrorFigures since_start() const;

 private:
  struct Frame {
    std::vector<ErrorCounts::Step> steps;
    float max = 0.0F, pop_max = 0.0F;
  };

  Frame& ago(std::size_t frames_ago) { return ring_[(newest_ + most_frames - frames_ago) % most_frames]; }
  void forget(Frame& frame);

  std::array<Frame, most_frames> ring_;
  std::size_t newest_ = 0;
  std::size_t held_ = 0;  // frames whose samples count
  ErrorCounts counts_, all_counts_;
  float all_max_ = 0.0F, all_pop_max_ = 0.0F;
};

}  // namespace throng::anim
