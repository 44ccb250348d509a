#pragma once

#include "app/commands/bench/options.h"
#include "app/commands/bench/report.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// `throng bench --sweep grain`: below which size tasks are too small. The first value of each list counts.
anim::Result<BenchReport> sweep_grain(const BenchOptions& options);

}  // namespace throng::app
