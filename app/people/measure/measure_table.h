#pragma once

#include <string>

#include "engine/tracks/trajectories.h"

namespace throng::app {

/// Returns a table of the people of a recorded crowd as CSV: a line for each of the file's rows from `first` to `last`
/// second of its clock, by frame, then as the file begins people. Columns have PedPy's names: id, frame, time, x, y,
/// speed, density. Places are the file's, speed and density are those of CrowdMeasures, and a density that is not known
/// is empty. `cut_off` is Tuning::density_cut_off. A frame is a time in rows of the file since second 0.
std::string measure_table(const Trajectories& tracks, double first, double last, float cut_off);

}  // namespace throng::app
