#pragma once

#include <optional>
#include <string>
#include <utility>

#include "engine/tracks/reading.h"

namespace throng::app {

/// The recorded or simulated crowd that a run shows.
struct TrajectoryOptions {
  std::string file;  ///< empty: there is none
  TrackReading reading;
  std::optional<double> start;  ///< seconds of the file's clock; unset: where the part begins in the way it is played
  std::optional<double> rate;   ///< seconds of the file's clock a second, not 0; below 0: backwards
  std::optional<std::pair<double, double>> part;  ///< seconds of the file's clock, in any order; unset: all of it
  bool repeats = false;                           ///< without a window too
};

}  // namespace throng::app
