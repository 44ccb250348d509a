#pragma once

#include <string>

#include "engine/anim/survey/placement_guess.h"

namespace throng::app {

/// The size and place of the character shown.
struct PlacementReport {
  anim::PlacementChoice choice;  ///< the requested placement
  double scale = 1.0;            ///< applied: metres a unit of its file
  double guessed_scale = 1.0;    ///< applied where none is asked for
  double units_tall = 0.0;       ///< its height in units of its file, turned upright; 0 without extent
  std::string reasons;           ///< a sentence: the height and why
};

}  // namespace throng::app
