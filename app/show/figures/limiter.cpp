#include "app/show/figures/limiter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

constexpr double frames_averaged = 30.0;
constexpr double longest_smooth_frame = 40.0;  // milliseconds
constexpr double little_of_a_frame = 0.2, most_of_the_poses = 0.8;

/// The name of a part at the beginning of a sentence, and in a list.
struct PartName {
  const char* first;
  const char* listed;
};
constexpr std::array<PartName, 4> part_names = {
    {{"Animation", "animation"}, {"Upload", "upload"}, {"Draw submission", "draw submission"}, {"The GPU", "GPU"}}};
constexpr PartName filling_by_processor = {"Filling pixels on the processor", "filling pixels on the processor"};

std::array<double, 4> parts_of(const FrameTimes& times) {
  return {times.animation_ms, times.upload_ms, times.submission_ms, times.wait_ms};
}

std::string milliseconds(double value) { return fixed(value, 1); }

}  // namespace

Limiter limiting_part(const FrameTimes& times) {
  const std::array<double, 4> parts = parts_of(times);
  return static_cast<Limiter>(std::ranges::max_element(parts) - parts.begin());
}

std::string limit_sentence(const FrameTimes& times, bool on_processor) {
  const std::array<double, 4> parts = parts_of(times);
  const double whole = times.frame_ms();
  if (whole <= 0.0) return {};
  const auto most = static_cast<std::size_t>(limiting_part(times));
  const auto name = [on_processor](std::size_t part) {
    const bool fills = on_processor && part == static_cast<std::size_t>(Limiter::gpu);
    return fills ? filling_by_processor : part_names[part];
  };
  std::string others;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i == most) continue;
    others += (others.empty() ? "" : ", ") + std::string(name(i).listed) + " " + milliseconds(parts[i]);
  }
  return std::string(name(most).first) + " takes the longest: " + milliseconds(parts[most]) + " of " +
         milliseconds(whole) + " ms a frame; " + others;
}

std::string skipping_sentence(const FrameTimes& times, std::span<const int> agents_by_interval) {
  const double frame = times.frame_ms();
  if (frame <= longest_smooth_frame) return {};
  const std::string rate = "At " + milliseconds(1000.0 / frame) + " frames a second skipping does not pay: ";
  if (times.animation_ms < little_of_a_frame * frame) {
    return rate + "animation takes only " + milliseconds(times.animation_ms) + " of " + milliseconds(frame) +
           " ms a frame, and no more could be saved.";
  }
  double agents = 0.0, poses = 0.0;
  for (std::size_t i = 0; i < agents_by_interval.size(); ++i) {
    agents += agents_by_interval[i];
    poses += agents_by_interval[i] / static_cast<double>(i + 1);
  }
  if (agents == 0.0 || poses < most_of_the_poses * agents) return {};
  return rate + "a pose that misses one frame is " + milliseconds(frame) + " ms old, in which limbs go far, so " +
         std::to_string(std::lround(100.0 * poses / agents)) + "% of the poses are computed all the same.";
}

void LimiterOverFrames::add(const FrameTimes& times) {
  const double part = begun_ ? 1.0 / frames_averaged : 1.0;
  const auto approach = [part](double& mean, double value) { mean += (value - mean) * part; };
  approach(mean_.animation_ms, times.animation_ms);
  approach(mean_.upload_ms, times.upload_ms);
  approach(mean_.submission_ms, times.submission_ms);
  approach(mean_.wait_ms, times.wait_ms);
  begun_ = true;
}

}  // namespace throng::app
