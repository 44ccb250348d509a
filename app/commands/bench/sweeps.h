#pragma once

#include "app/commands/bench/options.h"
#include "app/commands/bench/report.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// What `throng bench --sweep` looks at. The first value of each list counts.
anim::Result<BenchReport> run_sweep(const BenchOptions& options);

/// One each (see Sweep).
anim::Result<BenchReport> sweep_grain(const BenchOptions& options);
anim::Result<BenchReport> sweep_streams(const BenchOptions& options);
anim::Result<BenchReport> sweep_cost(const BenchOptions& options);

}  // namespace throng::app
