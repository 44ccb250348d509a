#pragma once

#include <string>

#include "engine/tracks/trajectories.h"

namespace throng::app {

/// Says for a person what a file of trajectories holds: people, rows, time and place, findings and oddities.
std::string tracks_text(const Trajectories& tracks);

/// Returns the same facts as one JSON object; README.md beside this file lists the keys.
std::string tracks_json(const Trajectories& tracks);

}  // namespace throng::app
