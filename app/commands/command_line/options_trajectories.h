#pragma once

#include <optional>
#include <string>

#include "app/commands/command_line/option_reader.h"
#include "app/settings/settings.h"

namespace throng::app {

/// Adds the options that say how a file of trajectories is read.
void declare_track_reading(OptionReader& reader, TrackReading& reading);

/// Adds the options of a recorded crowd.
void declare_trajectories(OptionReader& reader, DemoOptions& options);

/// Makes the scene `tracks`, if a recorded crowd is named. `--up` is the crowd's where it has the crowd's name, or no
/// model is named. Returns a contradiction, "--start: goes with --trajectories".
std::optional<std::string> settle_trajectories(const OptionReader& reader, DemoOptions& options);

}  // namespace throng::app
