#pragma once

#include <span>
#include <vector>

#include "app/settings/settings.h"
#include "engine/anim/lod/lod_choices.h"

namespace throng::app {

/// From `metres` on, agents have this interval.
struct IntervalThreshold {
  float metres = 0;
  int interval = 1;
};

/// Where the interval changes, the nearest first, by the distance rule of the tuning.
std::vector<IntervalThreshold> interval_thresholds(const Tuning& tuning);

/// From where errors are looked at.
struct ErrorView {
  float tolerance_pixels = 1;  ///< above 0
  float pixels_per_unit = 1;   ///< of a metre, a metre away
};

/// By the tolerance in pixels, as far as 200 metres, for who is as tall as the character, as important as most and not
/// in the middle of the picture. Mostly it grows; it shrinks where fewer bones, more often, are cheaper.
std::vector<IntervalThreshold> interval_thresholds(const anim::MotionLod& motion, const ErrorView& view);

/// Frames between two updates of an agent that far away.
int interval_at(std::span<const IntervalThreshold> thresholds, float metres);

}  // namespace throng::app
