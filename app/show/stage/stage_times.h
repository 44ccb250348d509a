#pragma once

namespace throng::app {

/// The milliseconds that the parts of the last frame took on the calling thread.
struct StageTimes {
  double crowd_ms = 0;      ///< Stage::move: where agents go, and which clips they play
  double selection_ms = 0;  ///< which agents are in view, and how exactly each is posed
  double pose_ms = 0;       ///< the rest of Stage::pose: slots, feet, palettes, errors
};

}  // namespace throng::app
