#include <cstdio>
#include <exception>
#include <functional>
#include <initializer_list>
#include <new>
#include <string>
#include <variant>

#include "app/command_line/options.h"
#include "app/commands/bake/command.h"
#include "app/commands/bench/command.h"
#include "app/commands/inspect/command.h"
#include "app/commands/lod/command.h"
#include "app/commands/pose/command.h"
#include "app/demo/demo.h"
#include "app/files/atomic_file.h"
#include "app/files/exit_status.h"

namespace throng::app {
namespace {

struct Output {
  std::string option;
  std::string file;
};

/// Runs a command whose files can all be written; that is known before its first frame, not after its last.
int run_if_writable(std::initializer_list<Output> outputs, const std::function<int()>& run) {
  for (const auto& [option, file] : outputs) {
    if (file.empty() || file == "-") continue;
    const anim::Status writable = check_can_be_written(option, file);
    if (!writable) return end_with(exit_job_failed, writable.error().message);
  }
  return run();
}

struct Run {
  int operator()(const DemoOptions& options) const {
    return run_if_writable({{"--screenshot", options.screenshot},
                            {"--stats", options.stats},
                            {"--trace", options.trace},
                            {"--record", options.record},
                            {"--ui-map", options.ui_map}},
                           [&] { return run_demo(options); });
  }

  int operator()(const PoseOptions& options) const {
    return run_if_writable({{"--json", options.json}}, [&] { return run_pose(options); });
  }

  int operator()(const InspectOptions& options) const { return run_inspect(options); }

  int operator()(const LodOptions& options) const {
    return run_if_writable({{"--json", options.json}, {"--plot", options.plot}, {"--export", options.export_file}},
                           [&] { return run_lod(options); });
  }

  int operator()(const BenchOptions& options) const {
    return run_if_writable({{"--json", options.json}, {"--plot", options.plot}, {"--trace", options.trace}},
                           [&] { return run_bench(options); });
  }

  int operator()(const BakeOptions& options) const {
    return run_if_writable({{"-o", options.pack}}, [&] { return run_bake(options); });
  }

  int operator()(const ShowText& shown) const {
    std::fputs(shown.text.c_str(), stdout);
    return exit_done;
  }

  int operator()(const UsageError& error) const { return end_with(exit_usage, error.message); }
};

}  // namespace
}  // namespace throng::app

// NOLINTNEXTLINE(bugprone-exception-escape): end_with() makes one line of text
int main(int argument_count, char** arguments) {
  using namespace throng::app;
  try {
    return std::visit(Run{}, parse_command_line({arguments + 1, arguments + argument_count}));
  } catch (const std::bad_alloc&) {
    return end_with(exit_job_failed, "the machine has no memory left; ask for fewer agents or smaller models");
  } catch (const std::exception& error) {
    return end_with(exit_job_failed, error.what());
  }
}
