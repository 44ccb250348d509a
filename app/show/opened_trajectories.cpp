#include "app/show/opened_trajectories.h"

#include <utility>

#include "app/files/exit_status.h"
#include "app/trajectory/read.h"

namespace throng::app {

std::shared_ptr<const Trajectories> open_trajectories(const TrajectoryOptions& options, StartError& error) {
  auto read = read_trajectories(options.file, options.reading);
  if (!read) return fail(error, exit_job_failed, read.error().message), nullptr;
  return std::make_shared<const Trajectories>(std::move(*read));
}

}  // namespace throng::app
