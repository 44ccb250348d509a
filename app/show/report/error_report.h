#pragma once

#include <string>
#include <vector>

#include "engine/anim/lod/error_window.h"

namespace throng::app {

/// Reports the error that level of detail shows on the screen.
struct ErrorReport {
  anim::ErrorFigures figures;      ///< over the last 60 frames, and further back where these have few samples
  anim::ErrorIntervals intervals;  ///< where the percentiles may lie by chance
  std::vector<float> p99_history, pop_history;  ///< pixels, oldest first, up to 240: a value for two frames
  std::string skipping_sentence;                ///< why skipping saves little at this frame rate; empty: it does pay
};

}  // namespace throng::app
