#pragma once

#include <optional>
#include <vector>

#include "app/commands/bench/options.h"
#include "app/figures/timeline_log.h"
#include "app/files/json.h"

namespace throng::app {

/// Every combination of the lists, the first list slowest.
std::vector<BenchCase> bench_cases(const BenchOptions& options);

/// How many rounds each pass over a table of `cases` takes of each of them: cases take turns, some rounds at a time, so
/// that a drift of the machine meets all rows alike. One case alone is one pass.
std::vector<int> rounds_of_passes(int rounds, std::size_t cases);

/// Times all combinations, a row of figures each; of several, each row's time over the first one's, too. `trace`: gets
/// some frames of each. Null where it is done, else what ended it, which was said.
std::optional<int> run_cases(const BenchOptions& options, std::vector<Json>& rows, std::optional<TimelineLog>& trace);

}  // namespace throng::app
