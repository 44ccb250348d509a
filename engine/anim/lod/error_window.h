#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

/// How far off what is shown is, over a crowd and some time (DESIGN "Measured, not guessed"). Pixels on screen.
namespace throng::anim {

/// Of the agents measured. All 0 where nobody was.
struct ErrorFigures {
  /// As few leave an estimate of a ninety-ninth percentile to chance.
  static constexpr std::uint32_t samples_for_p99 = 1000;

  float p50 = 0.0F;
  float p99 = 0.0F;
  float max = 0.0F;
  float pop_max = 0.0F;  ///< the largest change of an error from one frame to the next
  std::uint32_t samples = 0;

  bool p99_is_known() const { return samples >= samples_for_p99; }
};

/// One agent in one frame.
struct ErrorSample {
  float error = 0.0F;        ///< pixels, 0 or more
  std::optional<float> pop;  ///< pixels; none if it was not measured in the frame before
};

/// Counts of errors, in steps of 2%: percentiles of any number of samples in no time. A percentile is the upper end of
/// its step, so never too small; below a 256th of a pixel it is 0.
class ErrorCounts {
 public:
  using Step = std::uint16_t;

  static Step step_of(float pixels);

  void add(Step step) { ++counts_[step], ++total_; }
  void remove(Step step) { --counts_[step], --total_; }
  /// What `part` of the samples, 0 to 1, do not exceed; 0 without samples.
  float percentile(double part) const;
  std::uint64_t total() const { return total_; }

 private:
  static constexpr int least_exponent = -8, most_exponent = 14;  // of 2
  static constexpr int steps_an_octave = 32;
  static constexpr std::size_t step_count = (most_exponent - least_exponent) * steps_an_octave + 1;

  std::array<std::uint32_t, step_count> counts_{};
  std::uint64_t total_ = 0;
};

/// Errors of the last 60 frames, and of all frames since the start. Percentiles look further back, up to 600 frames,
/// where the last 60 have too few samples for the ninety-ninth.
class ErrorWindow {
 public:
  static constexpr std::size_t frames = 60;
  static constexpr std::size_t most_frames = 600;

  /// Room for so many samples in each of the last 60 frames, so that add() does not allocate.
  void reserve(std::size_t samples_a_frame);
  /// Forgets the oldest frames.
  void begin_frame();
  /// Within the frame begun last.
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
