#pragma once

#include <string>

#include "app/commands/bench/command.h"
#include "engine/base/json/json.h"
#include "engine/base/result.h"

namespace throng::app {

/// The figures of a measurement, for a person, for programs, and drawn (empty: there is nothing to draw).
struct BenchReport {
  std::string text;
  Json json;
  std::string plot;
};

/// Writes a report to where the options say, or the sentence of its error. Returns the exit status.
int end_with_report(const BenchOptions& options, const anim::Result<BenchReport>& report);

}  // namespace throng::app
