#pragma once

#include "app/trajectory/raw_rows.h"
#include "app/trajectory/trajectories.h"

namespace throng::app {

/// Adds to `tracks.said` what can be read but cannot be true: speeds, sizes and heights that no crowd has, and a place
/// that lies elsewhere. Each is a sentence with the option that may mend it. `facts` are those of the file; the plan
/// of the tracks is there. Some 50,000 steps of the first 2000 people are looked at.
void add_doubts(const RowFacts& facts, Trajectories& tracks);

}  // namespace throng::app
