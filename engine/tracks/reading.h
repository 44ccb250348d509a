#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace throng {

/// Says what the height z of a file's rows is.
enum class TrackHeight : std::uint8_t {
  by_format,  ///< the head's in the text of the Jülich archive, the ground's elsewhere
  head,
  ground,
  none,  ///< z is left out: people are on the ground at 0
};

/// Says what a file's angles are.
enum class TrackAngle : std::uint8_t {
  guessed,
  degrees,  ///< counterclockwise from +x, as radians are
  radians,
  north,  ///< degrees clockwise from north
  none,   ///< angles are left out: people look where they go
};

/// The axis of a file that points up. The ground is the file's (x, y) where z points up, and (x, -z) where y does.
enum class TrackUp : std::uint8_t { z, y };

/// Says how trajectories are read. The reader finds each value that is not set, and lists it in Trajectories::remarks.
struct TrackReading {
  std::optional<double> fps = {};             ///< frames a second of rows that have frames
  std::optional<double> times_a_second = {};  ///< units of time in a second, of rows that have times
  std::optional<double> metres_a_unit = {};   ///< metres that a unit of x, y and z is
  TrackUp up = TrackUp::z;
  TrackHeight height = TrackHeight::by_format;
  TrackAngle angle = TrackAngle::guessed;
  std::string walls = {};  ///< a file of read_ground_plan(); empty: the plan in or beside the file
  bool lenient = false;    ///< skip rows that are wrong, and count them

  friend bool operator==(const TrackReading&, const TrackReading&) = default;
};

/// Is called with the share of the file that is read, from 0 to 1, at most some ten times a second.
using ReadProgress = std::function<void(double)>;

}  // namespace throng
