#pragma once

#include <memory>

#include "app/settings/trajectory_options.h"
#include "app/show/starting_characters.h"
#include "engine/tracks/trajectories.h"

namespace throng::app {

/// Reads the recorded crowd that a run names, and says on a terminal how far it is. Returns null and sets the error
/// where it cannot be read.
std::shared_ptr<const Trajectories> open_trajectories(const TrajectoryOptions& options, StartError& error);

}  // namespace throng::app
