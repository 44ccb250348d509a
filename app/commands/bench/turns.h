#pragma once

#include <optional>
#include <vector>

#include "app/commands/bench/command.h"
#include "app/show/figures/timeline_log.h"
#include "engine/base/json/json.h"

namespace throng::app {

/// Returns every combination of the lists. The first list varies slowest.
std::vector<BenchCase> bench_cases(const BenchOptions& options);

/// Returns the rounds that each pass over a table of `cases` takes of each of them. Cases take turns, a few rounds at a
/// time, so that a drift of the machine meets all rows alike. One case alone is one pass.
std::vector<int> rounds_of_passes(int rounds, std::size_t cases);

/// Times all combinations and adds a row of figures for each. If there are several, each row also has its time over the
/// first row's. `trace` gets some frames of each. Returns nothing when all went well, else the exit status, after one
/// line on standard error.
std::optional<int> run_cases(const BenchOptions& options, std::vector<Json>& rows, std::optional<TimelineLog>& trace);

}  // namespace throng::app
