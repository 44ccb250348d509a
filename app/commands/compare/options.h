#pragma once

#include <string>

#include "app/output/regression/tolerance.h"

namespace throng::app {

/// The options of `throng compare`.
struct CompareOptions {
  std::string expected, actual;  ///< pictures
  std::string difference;        ///< empty: not asked for
  Tolerance tolerance;           ///< without any limit, the pictures must be equal
  bool remove_parts = false;     ///< remove remains of killed runs beside the file to write
};

}  // namespace throng::app
