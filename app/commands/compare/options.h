#pragma once

#include <string>

#include "app/regression/tolerance.h"

namespace throng::app {

/// The options of `throng compare`.
struct CompareOptions {
  std::string expected, actual;  ///< pictures
  std::string difference;        ///< empty: not asked for
  Tolerance tolerance;           ///< without any limit, the pictures must be the same
  bool remove_parts = false;     ///< what killed runs left beside the file to write is removed
};

}  // namespace throng::app
