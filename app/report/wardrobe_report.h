#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/wardrobe/cast_tuning.h"

namespace throng::app {

/// The rules by which the agents of the character shown dress.
struct WardrobeReport {
  CastTuning tuning;    ///< in force; without bodies where the character has no rules
  CastTuning standard;  ///< as the file says
  std::string file;     ///< where the rules come from; empty: no file
  int holding = 0;      ///< agents who hold something
};

/// A character's rules get other values.
struct NewCast {
  std::size_t character = 0;
  CastTuning tuning;
};

/// The requests that a person makes of the rules in a frame.
struct WardrobeCommands {
  std::optional<NewCast> cast;
  std::optional<std::string> save;  ///< NAME of NAME.cast.json in the working folder
  std::optional<std::string> load;  ///< such a NAME; empty: the file in force, once more
};

}  // namespace throng::app
