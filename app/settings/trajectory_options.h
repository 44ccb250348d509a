#pragma once

#include <optional>
#include <string>

#include "app/trajectory/reading.h"

namespace throng::app {

/// The recorded or simulated crowd that a run shows.
struct TrajectoryOptions {
  std::string file;  ///< empty: there is none
  TrackReading reading;
  std::optional<double> start;  ///< seconds of the file's clock at which the crowd begins; unset: at its first row
};

}  // namespace throng::app
