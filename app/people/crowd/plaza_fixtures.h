#pragma once

#include <vector>

#include "app/people/crowd/plaza_plan.h"
#include "engine/base/random.h"

namespace throng::app {

/// Adds the fixtures in the middle of the plaza, or of each of its blocks: `side` is the side of the crowd's square,
/// and `blocks` the number of blocks in a row. Where there is no room among the crowd, the fountain stands behind it,
/// as the first camera sees it.
void add_middle_fixtures(double side, int blocks, double spacing, std::vector<Fixture>& fixtures);

/// Adds a few things to a place that no lane crosses.
void add_corner_of_rest(const Square& free, double spacing, Random& random, std::vector<Fixture>& fixtures);

/// Adds rows of trees, benches and lamps along the crowd's square and along the avenues between its blocks.
void add_rows(double side, int blocks, double spacing, std::vector<Fixture>& fixtures);

}  // namespace throng::app
