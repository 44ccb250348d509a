#pragma once

#include <string>
#include <vector>

#include "app/settings/settings.h"

namespace throng::app {

/// The options of `throng check`.
struct CheckOptions {
  std::string cases;                  ///< the file of cases
  std::vector<std::string> names;     ///< of the cases to draw; empty: all
  std::vector<ContextKind> contexts;  ///< in place of the cases' own; empty: their own
  bool update = false;                ///< expected pictures are written and not compared with
  bool force = false;                 ///< also pictures that git could not bring back
  std::string out = "throng-check";   ///< the folder for drawn pictures
  std::string report, junit;          ///< empty: the report goes into `out`, and no XML is written
  std::string data;                   ///< folder of shaders and assets
};

/// Runs `throng check`: draws the cases of a file and holds them against the expected pictures. Returns the exit
/// status.
int run_check(const CheckOptions& options);

}  // namespace throng::app
