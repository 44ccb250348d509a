#include "app/commands/compare/command.h"

#include <vector>

#include "app/files/exit_status.h"
#include "app/output/regression/compare.h"
#include "app/output/regression/origin.h"
#include "engine/base/files/output_file.h"

namespace throng::app {
namespace {

Status compare(const CompareOptions& options) {
  const auto expected = read_compared(options.expected);
  if (!expected) return expected.error();
  const auto actual = read_compared(options.actual);
  if (!actual) return actual.error();
  const std::string other = other_origin(read_origin(options.expected), read_origin(options.actual));
  const std::string first = other.empty() ? "" : other + "; ";
  const auto difference = measure_difference(*expected, *actual);
  if (!difference) return Error{first + difference.error().message};
  if (std::string unfit = unfit_limits(*difference, options.tolerance); !unfit.empty()) return Error{unfit};
  if (!options.difference.empty()) {
    const auto written = render::write_png(paint_difference(*expected, *actual), options.difference);
    if (!written) return written.error();
  }
  if (Status told = print(figures_text(*difference) + "\n"); !told) return told;
  const std::vector<JudgedFigure> figures = judge(*difference, options.tolerance);
  if (!all_within(figures)) return Error{first + excess_text(figures)};
  return Done{};
}

}  // namespace

int run_compare(const CompareOptions& options) { return end_with(compare(options)); }

}  // namespace throng::app
