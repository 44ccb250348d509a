#pragma once

#include "engine/anim/import/import.h"
#include "engine/anim/survey/placement_guess.h"

namespace throng::app {

/// How the files of characters are read.
struct LoadOptions {
  import::ImportOptions import{};
  anim::PlacementChoice placement{};  ///< size and place; what it leaves open is guessed
};

}  // namespace throng::app
