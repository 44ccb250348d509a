#include "app/show/lod/lod_thresholds.h"

#include <cmath>

namespace throng::app {

namespace {

constexpr float farthest = 200.0F;         // metres
constexpr float beyond_rounding = 1.001F;  // meets a step of the allowed error from above

}  // namespace

std::vector<IntervalThreshold> interval_thresholds(const Tuning& tuning) {
  std::vector<IntervalThreshold> thresholds;
  for (int interval = 2; interval <= tuning.lod.largest_interval; ++interval) {
    const auto steps = static_cast<float>(interval - 2);
    thresholds.push_back({tuning.lod.full_rate_distance + steps * tuning.lod.interval_growth, interval});
  }
  return thresholds;
}

std::vector<ChoiceThreshold> choice_thresholds(const anim::MotionLod& motion, const ErrorView& view) {
  std::vector<ChoiceThreshold> thresholds{{0.0F, motion.choose(0.0F)}};
  for (int step = 0; step < anim::allowance_steps; ++step) {
    const float allowed = anim::least_allowance_metres * std::exp2(static_cast<float>(step) / anim::steps_an_octave);
    const anim::LodChoice chosen = motion.choose(allowed * beyond_rounding);
    if (chosen == thresholds.back().choice) continue;
    thresholds.push_back({allowed * view.pixels_per_unit / view.tolerance_pixels, chosen});
  }
  return thresholds;
}

std::vector<IntervalThreshold> interval_thresholds(const anim::MotionLod& motion, const ErrorView& view) {
  std::vector<IntervalThreshold> thresholds;
  int interval = 1;
  for (const auto& [metres, choice] : choice_thresholds(motion, view)) {
    if (metres > farthest) break;
    if (choice.interval != interval) thresholds.push_back({metres, choice.interval});
    interval = choice.interval;
  }
  return thresholds;
}

int interval_at(std::span<const IntervalThreshold> thresholds, float metres) {
  int interval = 1;
  for (const IntervalThreshold& threshold : thresholds) {
    if (threshold.metres <= metres) interval = threshold.interval;
  }
  return interval;
}

}  // namespace throng::app
