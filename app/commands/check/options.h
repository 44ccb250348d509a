#pragma once

#include <string>
#include <vector>

#include "app/settings/settings.h"

namespace throng::app {

/// The options of `throng check`.
struct CheckOptions {
  std::string cases;                  ///< the file of cases
  std::vector<std::string> names;     ///< those of the cases; empty: all
  std::vector<ContextKind> contexts;  ///< in place of those of the cases; empty: theirs
  bool update = false;                ///< expected pictures are written and not compared with
  bool force = false;                 ///< also those that could not be brought back
  std::string out = "throng-check";   ///< the folder for what is drawn
  std::string report, junit;          ///< empty: the report goes into `out`, and no XML is written
  std::string data;                   ///< folder of shaders and assets
};

}  // namespace throng::app
