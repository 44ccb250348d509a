#pragma once

#include <string>

#include "engine/tracks/trajectories.h"

namespace throng {

/// Gathers one kind of oddity, with the first in time.
struct OddityTally {
  std::size_t count = 0;
  double first_seconds = 0.0;
  std::string first = {};

  /// `text()` is called for the first oddity alone.
  template <typename Text>
  void add(double seconds, Text text) {
    if (count++ > 0 && seconds >= first_seconds) return;
    first_seconds = seconds;
    first = text();
  }
  void add(const OddityTally& other);
};

/// Finds gaps, teleports and people who stand on each other. In a crowd of many rows the search covers some of its
/// frames. `rows_a_second` is the rate of most people.
void find_oddities(const std::vector<PersonTrack>& persons, double rows_a_second, TrackReport& report);

/// Adds a kind to the report if there are any.
void report_oddity(TrackOddity oddity, const OddityTally& tally, TrackReport& report);

}  // namespace throng
