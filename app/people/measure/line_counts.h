#pragma once

#include <cstddef>

#include <glm/vec2.hpp>

#include "engine/tracks/trajectories.h"

namespace throng::app {

/// Says how many people passed a line, seen from its beginning to its end. A person counts at each passage, so a
/// person who turns round and comes back counts on both sides.
struct LineCounts {
  std::size_t to_left = 0, to_right = 0;
  double seconds = 0.0;  ///< in which they passed
};

/// Counts the people who pass a line from `first` to `last` second of the file's clock. `begin` and `end` are two
/// places of the file, in metres. A person goes straight from row to row; a jump that is faster than fastest_person is
/// no passage.
LineCounts count_passages(const Trajectories& tracks, const glm::dvec2& begin, const glm::dvec2& end, double first,
                          double last);

}  // namespace throng::app
