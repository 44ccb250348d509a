#pragma once

#include <span>
#include <vector>

#include "app/settings/settings.h"
#include "engine/anim/lod/lod_choices.h"

namespace throng::app {

/// The interval of agents that are at least `metres` away.
struct IntervalThreshold {
  float metres = 0;
  int interval = 1;
};

/// Returns the distances where the interval changes by the distance rule of the tuning, the nearest first.
std::vector<IntervalThreshold> interval_thresholds(const Tuning& tuning);

/// The tolerance of a view, and its scale.
struct ErrorView {
  float tolerance_pixels = 1;  ///< above 0
  float pixels_per_unit = 1;   ///< pixels that one metre covers at a distance of one metre
};

/// The interval and the bone level of agents that are at least `metres` away.
struct ChoiceThreshold {
  float metres = 0;
  anim::LodChoice choice;
};

/// Returns the distances where interval or bone level change by the tolerance in pixels, the first of them 0. They hold
/// for an agent that is as tall as the character, as important as most, and not in the middle of the picture.
std::vector<ChoiceThreshold> choice_thresholds(const anim::MotionLod& motion, const ErrorView& view);

/// Returns the distances where the interval changes by the tolerance in pixels, up to 200 metres. They hold for
/// the agents of choice_thresholds(). The interval mostly grows with distance; it shrinks where fewer bones, more
/// often, are cheaper.
std::vector<IntervalThreshold> interval_thresholds(const anim::MotionLod& motion, const ErrorView& view);

/// Returns the frames from one update to the next of an agent that is `metres` away.
int interval_at(std::span<const IntervalThreshold> thresholds, float metres);

}  // namespace throng::app
