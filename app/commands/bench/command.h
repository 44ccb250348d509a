#pragma once

#include "app/commands/bench/options.h"

namespace throng::app {

/// Measures poses per second; every figure is taken in interleaved rounds of the same run. Returns the exit status.
int run_bench(const BenchOptions& options);

}  // namespace throng::app
