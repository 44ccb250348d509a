#pragma once

#include "app/commands/bench/command.h"
#include "app/commands/bench/report.h"

namespace throng::app {

/// The numbers of agents that `throng bench --draw` measures by default.
std::vector<int> usual_drawn_agents();

/// Measures whole frames of each number of agents, one after the other, each for the frames or the seconds in the
/// options, whichever ends first, and for one frame at least. Errors: there is no such device, camera or model.
Result<BenchReport> measure_drawing(const BenchOptions& options);

}  // namespace throng::app
