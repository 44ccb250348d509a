#pragma once

#include <array>
#include <memory>

#include "app/people/crowd/people_over_time.h"
#include "engine/tracks/track_clock.h"

namespace throng::app {

/// The rates at which the timeline plays a recorded crowd; 1 is the rate of the file.
inline constexpr std::array<double, 7> track_rates = {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0};

/// All that the timeline shows of a recorded crowd. What a person asks for is another clock.
struct TracksReport {
  TrackClock clock;
  std::shared_ptr<const PeopleOverTime> people;  ///< of the whole file; never null
};

}  // namespace throng::app
