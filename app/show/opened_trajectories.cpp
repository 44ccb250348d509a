#include "app/show/opened_trajectories.h"

#include <string>
#include <utility>

#include "app/files/exit_status.h"
#include "app/files/progress_line.h"
#include "engine/tracks/read.h"

namespace throng::app {

std::shared_ptr<const Trajectories> open_trajectories(const TrajectoryOptions& options, StartError& error) {
  const auto show_share = [&](double share) {
    show_progress("reading " + options.file + ": " + std::to_string(static_cast<int>(100.0 * share)) + "%");
  };
  auto read = read_trajectories(options.file, options.reading, show_share);
  show_progress("");
  if (!read) return fail(error, exit_job_failed, read.error().message), nullptr;
  return std::make_shared<const Trajectories>(std::move(*read));
}

}  // namespace throng::app
