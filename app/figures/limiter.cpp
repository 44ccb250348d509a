#include "app/figures/limiter.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace throng::app {
namespace {

constexpr double frames_averaged = 30.0;
constexpr std::array<const char*, 4> names{"Animation", "Upload", "Draw submission", "The GPU"};
constexpr std::array<const char*, 4> names_in_list{"animation", "upload", "draw submission", "GPU"};

std::array<double, 4> parts_of(const FrameTimes& times) {
  return {times.animation_ms, times.upload_ms, times.submission_ms, times.wait_ms};
}

std::string milliseconds(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.1f", value);
  return text;
}

}  // namespace

Limiter who_limits(const FrameTimes& times) {
  const std::array<double, 4> parts = parts_of(times);
  return static_cast<Limiter>(std::ranges::max_element(parts) - parts.begin());
}

std::string limit_sentence(const FrameTimes& times) {
  const std::array<double, 4> parts = parts_of(times);
  const double whole = parts[0] + parts[1] + parts[2] + parts[3];
  if (whole <= 0.0) return {};
  const auto most = static_cast<std::size_t>(who_limits(times));
  std::string others;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i == most) continue;
    others += (others.empty() ? "" : ", ") + std::string(names_in_list[i]) + " " + milliseconds(parts[i]);
  }
  return std::string(names[most]) + " limits you: " + milliseconds(parts[most]) + " of " + milliseconds(whole) +
         " ms a frame; " + others;
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
