#include <cstdio>
#include <initializer_list>
#include <string>
#include <variant>

#include "app/atomic_file.h"
#include "app/bench_command.h"
#include "app/demo.h"
#include "app/exit_status.h"
#include "app/inspect_command.h"
#include "app/options.h"
#include "app/pose_command.h"

namespace throng::app {
namespace {

struct Output {
  std::string option;
  std::string file;
};

/// Whether each file that was asked for can be written; known before the first frame, not after the last.
anim::Status check_outputs(std::initializer_list<Output> outputs) {
  for (const auto& [option, file] : outputs) {
    if (file.empty() || file == "-") continue;
    if (anim::Status writable = check_can_be_written(option, file); !writable) return writable;
  }
  return anim::Done{};
}

struct Run {
  int operator()(const DemoOptions& options) const {
    const anim::Status writable = check_outputs({{"--screenshot", options.screenshot},
                                                 {"--stats", options.stats},
                                                 {"--trace", options.trace},
                                                 {"--ui-map", options.ui_map}});
    if (!writable) return end_with(exit_job_failed, writable.error().message);
    return run_demo(options);
  }

  int operator()(const PoseOptions& options) const {
    const anim::Status writable = check_outputs({{"--json", options.json}});
    if (!writable) return end_with(exit_job_failed, writable.error().message);
    return run_pose(options);
  }

  int operator()(const InspectOptions& options) const { return run_inspect(options); }

  int operator()(const BenchOptions& options) const {
    const anim::Status writable = check_outputs({{"--json", options.json}});
    if (!writable) return end_with(exit_job_failed, writable.error().message);
    return run_bench(options);
  }

  int operator()(const ShowText& shown) const {
    std::fputs(shown.text.c_str(), stdout);
    return exit_done;
  }

  int operator()(const UsageError& error) const { return end_with(exit_usage, error.message); }
};

}  // namespace
}  // namespace throng::app

int main(int argument_count, char** arguments) {
  using namespace throng::app;
  return std::visit(Run{}, parse_command_line({arguments + 1, arguments + argument_count}));
}
