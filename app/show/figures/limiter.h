#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "app/show/stage/stage_times.h"

namespace throng::app {

/// The parts of a drawn frame, in milliseconds of the calling thread, one after the other.
struct FrameTimes {
  double animation_ms = 0;               ///< crowd, level of detail, poses and palettes
  double upload_ms = 0;                  ///< records composed and handed to the device
  double submission_ms = 0;              ///< draw calls
  double wait_ms = 0;                    ///< for the device to be done
  StageTimes stage = {};                 ///< the parts of the animation
  std::optional<double> device_ms = {};  ///< by the device's own timer, which runs beside these parts

  double drawing_ms() const { return upload_ms + submission_ms + wait_ms; }
  double frame_ms() const { return animation_ms + drawing_ms(); }
};

enum class Limiter : std::uint8_t { animation, upload, submission, gpu };

/// Returns the part that takes most of the frame, the earlier one of two that take equally long.
Limiter limiting_part(const FrameTimes& times);

/// Returns "Animation takes the longest: 4.1 of 9.3 ms a frame; upload 0.3, draw submission 0.6, GPU 4.3", or nothing
/// before the first frame. `on_processor`: no GPU draws, but the processor.
std::string limit_sentence(const FrameTimes& times, bool on_processor);

/// Returns why skipping updates saves little at a low frame rate, below 25 frames a second: something else takes the
/// frame, or frames are so long that hardly any agent may miss one. `agents_by_interval[i]` agents in view are posed
/// every i + 1 frames. Returns nothing where the frame rate is higher, or where skipping does pay.
std::string skipping_sentence(const FrameTimes& times, std::span<const int> agents_by_interval);

/// Averages the parts over about half a second, so that a person can read them.
class LimiterOverFrames {
 public:
  void add(const FrameTimes& times);
  std::string sentence(bool on_processor) const { return limit_sentence(mean_, on_processor); }
  const FrameTimes& mean() const { return mean_; }

 private:
  FrameTimes mean_;
  bool begun_ = false;
};

}  // namespace throng::app
