#include "app/commands/bench/report.h"

#include "app/files/exit_status.h"
#include "engine/base/files/output_file.h"

namespace throng::app {
namespace {

anim::Status write(const BenchOptions& options, const anim::Result<BenchReport>& report) {
  if (!report) return report.error();
  if (!options.plot.empty()) {
    anim::Status written = write_whole_file(options.plot, report->plot);
    if (!written) return written;
  }
  if (!options.json.empty()) return write_output(options.json, report->json.dump(2) + "\n");
  return print(report->text);
}

}  // namespace

int end_with_report(const BenchOptions& options, const anim::Result<BenchReport>& report) {
  return end_with(write(options, report));
}

}  // namespace throng::app
