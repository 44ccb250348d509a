#pragma once

#include <string>
#include <vector>

namespace throng::app {

/// The options of `throng inspect`.
struct InspectOptions {
  std::string model;
  std::vector<std::string> clips_from;  ///< files whose clips are added to the largest model
  bool json = false;                    ///< one JSON object on standard output instead of lines for a person
};

}  // namespace throng::app
