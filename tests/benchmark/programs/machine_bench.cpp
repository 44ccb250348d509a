// What a machine with other local stores would do: throng_machine FILE, then the options of `throng bench`.

#include "app/files/exit_status.h"
#include "tests/benchmark/programs/machine.h"
#include "tests/benchmark/programs/program.h"

int main(int argument_count, char** arguments) {
  using namespace throng::app;
  if (argument_count < 2) return end_with(exit_usage, "throng_machine FILE [OPTIONS]: name a machine");
  const auto machine = read_machine(arguments[1]);
  if (!machine) return end_with(exit_job_failed, machine.error().message);
  return run_bench_program(argument_count - 1, arguments + 1,
                           [&](const BenchOptions& options) { return run_machine(options, *machine); });
}
