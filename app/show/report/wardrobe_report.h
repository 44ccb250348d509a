#pragma once

#include <string>

#include "app/people/wardrobe/cast_tuning.h"

namespace throng::app {

/// The rules by which the agents of the character shown dress.
struct WardrobeReport {
  CastTuning tuning;    ///< in force; without bodies where the character has no rules
  CastTuning standard;  ///< as the file says
  std::string file;     ///< where the rules come from; empty: no file
  int holding = 0;      ///< agents that hold something
};

}  // namespace throng::app
