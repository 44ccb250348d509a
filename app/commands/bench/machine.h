#pragma once

#include "app/commands/bench/options.h"
#include "app/commands/bench/report.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// Runs `throng bench --machine`: predicts how PUs with other local stores would do the transfers that it records here.
anim::Result<BenchReport> run_machine(const BenchOptions& options);

}  // namespace throng::app
