#pragma once

#include <vector>

#include "app/settings.h"

namespace throng::app {

/// Frames between two updates of an agent, as the distance rule of the tuning gives them; 1 under other rules.
int interval_at(const Tuning& tuning, float metres);

/// From `metres` on, agents have this interval.
struct IntervalThreshold {
  float metres = 0;
  int interval = 1;
};

/// Where the interval grows, the nearest first; none under other rules.
std::vector<IntervalThreshold> interval_thresholds(const Tuning& tuning);

}  // namespace throng::app
