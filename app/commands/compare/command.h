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

/// Runs `throng compare`: measures how far two pictures are apart. Returns the exit status.
int run_compare(const CompareOptions& options);

}  // namespace throng::app
