#pragma once

#include "engine/tracks/raw_rows.h"
#include "engine/tracks/trajectories.h"

namespace throng {

/// Adds to `tracks.remarks` a sentence for each value that can be read but cannot be true: speeds, sizes and heights
/// that no crowd has, and a place that lies elsewhere. It names the option that may mend it. `facts` are the file's;
/// the plan of the tracks is read already. The check takes some 50,000 steps of the first 2000 people.
void add_doubts(const RowFacts& facts, Trajectories& tracks);

}  // namespace throng
