#pragma once

#include "app/commands/bench/options.h"
#include "app/commands/bench/report.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// `throng bench --machine`: what PUs with other local stores would make of the transfers that are recorded here.
anim::Result<BenchReport> run_machine(const BenchOptions& options);

}  // namespace throng::app
