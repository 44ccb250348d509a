#pragma once

#include <functional>

#include "app/commands/bench/command.h"
#include "app/commands/bench/report.h"
#include "engine/base/result.h"

namespace throng::app {

/// Runs a program that takes the options of `throng bench` and writes one report as that command does. Returns the exit
/// status.
int run_bench_program(int argument_count, char** arguments,
                      const std::function<Result<BenchReport>(const BenchOptions& options)>& measure);

}  // namespace throng::app
