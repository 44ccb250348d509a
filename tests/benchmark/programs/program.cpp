#include "tests/benchmark/programs/program.h"

#include <cstdio>
#include <string>
#include <variant>
#include <vector>

#include "app/commands/command_line/options.h"
#include "app/files/exit_status.h"

namespace throng::app {

int run_bench_program(int argument_count, char** arguments,
                      const std::function<Result<BenchReport>(const BenchOptions& options)>& measure) {
  std::vector<std::string> words{"bench"};
  words.insert(words.end(), arguments + 1, arguments + argument_count);
  const ParsedCommand parsed = parse_command_line(words);
  if (const auto* shown = std::get_if<ShowText>(&parsed)) {
    std::fputs(shown->text.c_str(), stdout);
    return exit_done;
  }
  if (const auto* error = std::get_if<UsageError>(&parsed)) return end_with(exit_usage, error->message);
  const auto& options = std::get<BenchOptions>(parsed);
  if (!options.trace.empty()) return end_with(exit_usage, "--trace is of throng bench only");
  return end_with_report(options, measure(options));
}

}  // namespace throng::app
