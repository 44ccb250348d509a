#pragma once

#include <string>
#include <vector>

#include "engine/anim/import/import.h"
#include "engine/anim/survey/placement_guess.h"

namespace throng::app {

/// Says how the files of characters are read.
struct LoadOptions {
  import::ImportOptions import{};
  anim::PlacementChoice placement{};      ///< size and place; what it leaves open is guessed
  std::vector<std::string> clips_from{};  ///< files whose clips every character plays too
};

}  // namespace throng::app
