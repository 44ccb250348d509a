#pragma once

#include "app/commands/bench/command.h"
#include "app/commands/bench/report.h"
#include "engine/base/result.h"
#include "tests/benchmark/programs/machine_model.h"

namespace throng::app {

/// Predicts how PUs of a machine with other local stores would do the transfers that it records here.
Result<BenchReport> run_machine(const BenchOptions& options, const Machine& machine);

}  // namespace throng::app
