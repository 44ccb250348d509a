#include "app/commands/compare/command.h"

#include <vector>

#include "app/files/exit_status.h"
#include "app/output/regression/compare.h"
#include "app/output/regression/origin.h"
#include "engine/base/files/output_file.h"

namespace throng::app {

int run_compare(const CompareOptions& options) {
  const auto expected = read_compared(options.expected);
  if (!expected) return end_with(exit_job_failed, expected.error().message);
  const auto actual = read_compared(options.actual);
  if (!actual) return end_with(exit_job_failed, actual.error().message);
  const std::string other = other_origin(read_origin(options.expected), read_origin(options.actual));
  const std::string first = other.empty() ? "" : other + "; ";
  const auto difference = measure_difference(*expected, *actual);
  if (!difference) return end_with(exit_job_failed, first + difference.error().message);
  if (const std::string unfit = unfit_limits(*difference, options.tolerance); !unfit.empty()) {
    return end_with(exit_job_failed, unfit);
  }
  if (!options.difference.empty()) {
    const auto written = render::write_png(paint_difference(*expected, *actual), options.difference);
    if (!written) return end_with(exit_job_failed, written.error().message);
  }
  if (anim::Status told = print(figures_text(*difference) + "\n"); !told) {
    return end_with(exit_job_failed, told.error().message);
  }
  const std::vector<JudgedFigure> figures = judge(*difference, options.tolerance);
  return all_within(figures) ? static_cast<int>(exit_done) : end_with(exit_job_failed, first + excess_text(figures));
}

}  // namespace throng::app
