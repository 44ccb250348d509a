#pragma once

#include <string>

namespace throng::app {

/// What `throng inspect` was asked for.
struct InspectOptions {
  std::string model;
  bool json = false;  ///< one JSON object on standard output instead of lines for a person
};

}  // namespace throng::app
