#pragma once

#include <limits>

#include "engine/tracks/trajectories.h"

namespace throng {

/// The time in which a person is there, both ends included.
struct Presence {
  double first = 0.0, last = 0.0;  ///< seconds of the file's clock

  [[nodiscard]] bool has(double seconds) const { return seconds >= first && seconds <= last; }
};

/// Returns how long a row lasts, in seconds; a moment where no person has two rows.
inline double row_seconds(const Trajectories& all) {
  constexpr double shortest_row = 1e-3;
  return all.rows_a_second > 0.0 ? 1.0 / all.rows_a_second : shortest_row;
}

/// Returns when a person is there: from the first row to the last one. A person with a single row is there for
/// `row_seconds`, and a person without rows never.
inline Presence presence_of(const PersonTrack& person, double row_seconds) {
  constexpr double never = std::numeric_limits<double>::infinity();
  if (person.rows.empty()) return {never, never};
  const double first = person.rows.front().seconds;
  return {first, person.rows.size() > 1 ? person.rows.back().seconds : first + row_seconds};
}

}  // namespace throng
