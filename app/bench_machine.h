#pragma once

#include "app/bench_options.h"
#include "app/bench_report.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// `throng bench --machine`: what PUs with other local stores would make of the transfers that are recorded here.
anim::Result<BenchReport> run_machine(const BenchOptions& options);

}  // namespace throng::app
