#include <string>
#include <variant>

#include "app/commands/command_line/options.h"
#include "app/files/exit_status.h"
#include "app/files/program_version.h"
#include "app/window/demo.h"
#include "engine/base/files/output_file.h"

// The build makes it for the program alone; others who compile this file have none.
#if __has_include("throng_commit.h")
#include "throng_commit.h"
#else
#define THRONG_COMMIT "unknown"
#endif

namespace throng::app {
namespace {

int run(const DemoOptions& options) { return run_demo(options); }
int run(const PoseOptions& options) { return run_pose(options); }
int run(const InspectOptions& options) { return run_inspect(options); }
int run(const LodOptions& options) { return run_lod(options); }
int run(const BenchOptions& options) { return run_bench(options); }
int run(const BakeOptions& options) { return run_bake(options); }
int run(const CheckOptions& options) { return run_check(options); }
int run(const CompareOptions& options) { return run_compare(options); }

struct Run {
  int operator()(const auto& options) const {
    const RunFiles files = files_of(options);
    if (const Status checked = check(files); !checked) return end_with(checked);
    for (const std::string& line : report_or_remove_parts(files)) end_with(exit_done, line);
    choose_kernels(options);
    return run(options);
  }

  int operator()(const ShowText& shown) const { return end_with(print(shown.text)); }

  int operator()(const UsageError& error) const { return end_with(exit_usage, error.message); }
};

}  // namespace
}  // namespace throng::app

// NOLINTNEXTLINE(bugprone-exception-escape): end_with() makes one line of text
int main(int argument_count, char** arguments) {
  using namespace throng::app;
  end_in_words();
  set_program_commit(THRONG_COMMIT);
  try {
    return std::visit(Run{}, parse_command_line({arguments + 1, arguments + argument_count}));
  } catch (...) {
    return end_with(exit_job_failed, sentence_of_failure());
  }
}
