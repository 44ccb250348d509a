#pragma once

#include <string>

namespace throng::app {

/// The options of `throng inspect`.
struct InspectOptions {
  std::string model;
  bool strict = false;  ///< what would be repaired is refused
  bool json = false;    ///< one JSON object on standard output instead of lines for a person
};

}  // namespace throng::app
