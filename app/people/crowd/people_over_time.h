#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/tracks/presence.h"
#include "engine/tracks/trajectories.h"

namespace throng::app {

/// Tells how many people of a recorded crowd are there at each time of its clock.
class PeopleOverTime {
 public:
  static constexpr std::size_t columns = 1024;  ///< of most_by_column()

  PeopleOverTime() = default;
  explicit PeopleOverTime(const Trajectories& all);

  double first() const { return first_; }
  double last() const { return last_; }
  double row() const { return row_; }  ///< seconds from one row to the next
  std::size_t people() const { return firsts_.size(); }
  /// Returns how many are there at a time.
  std::size_t at(double seconds) const;
  /// Returns how many are there at the fullest time.
  std::size_t most() const { return most_; }
  /// Returns how many are there at the fullest time of each column: the file's time cut into equal parts.
  std::span<const std::uint32_t> most_by_column() const { return most_by_column_; }

 private:
  std::vector<double> firsts_, lasts_;  // in ascending order
  std::vector<std::uint32_t> most_by_column_;
  double first_ = 0.0, last_ = 0.0, row_ = 0.0;
  std::size_t most_ = 0;
};

}  // namespace throng::app
