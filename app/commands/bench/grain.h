#pragma once

#include "app/commands/bench/options.h"
#include "app/commands/bench/report.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// Runs `throng bench --sweep grain`: finds the size below which tasks are too small, for the first value of each list.
anim::Result<BenchReport> sweep_grain(const BenchOptions& options);

}  // namespace throng::app
