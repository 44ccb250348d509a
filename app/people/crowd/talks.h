#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "app/people/crowd/track_steps.h"
#include "engine/tracks/smooth_track.h"

namespace throng::app {

/// The person that another person looks at, and how much.
struct TalkMoment {
  std::uint32_t other = 0;
  float looks = 0.0F;   ///< 0: looks as without a talk, 1: looks at the other
  float speaks = 0.0F;  ///< 0: does not, 1: does
};

/// Tells which people of a recorded crowd talk to each other. People who stand an arm or two apart for a while, and can
/// turn their heads to each other, do so in turns: for some seconds both look at each other while one of them speaks,
/// then they look ahead for a moment. A third person looks at one of them. All of it is found once, from the tracks,
/// and is a function of time from then on.
class Talks {
 public:
  Talks() = default;
  /// Both have one element a person.
  Talks(std::span<const SmoothTrack> tracks, std::span<const TrackSteps> steps);

  TalkMoment at(std::size_t person, double seconds) const;

  /// A time in which a person looks at another.
  struct Glance {
    double begin = 0.0, end = 0.0;
    std::uint32_t other = 0;
    bool speaks = false;
  };

 private:
  std::vector<std::vector<Glance>> glances_;  // [person] in ascending time, apart from each other
};

}  // namespace throng::app
