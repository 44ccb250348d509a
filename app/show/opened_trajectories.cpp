#include "app/show/opened_trajectories.h"

#include <cstdio>
#include <utility>

#include <unistd.h>

#include "app/files/exit_status.h"
#include "app/trajectory/read.h"

namespace throng::app {
namespace {

void show_share(double share) { std::fprintf(stderr, "\r\033[Kreading %d%%", static_cast<int>(100.0 * share)); }

}  // namespace

std::shared_ptr<const Trajectories> open_trajectories(const TrajectoryOptions& options, StartError& error) {
  const bool is_seen = isatty(STDERR_FILENO) == 1;
  auto read = read_trajectories(options.file, options.reading, is_seen ? ReadProgress(show_share) : ReadProgress());
  if (is_seen) std::fputs("\r\033[K", stderr);
  if (!read) return fail(error, exit_job_failed, read.error().message), nullptr;
  return std::make_shared<const Trajectories>(std::move(*read));
}

}  // namespace throng::app
