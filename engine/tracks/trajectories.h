#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "engine/tracks/ground_plan.h"
#include "engine/tracks/reading.h"

namespace throng {

/// Metres a second. A faster person was lost and found again.
inline constexpr float fastest_person = 12.0F;

/// Says where a person was at a time. Places are in the program's axes, metres from Trajectories::origin: x to the
/// right, y up, z towards the reader of a map, so that a file's (x, y) on the ground is (x, -y) here.
///
///      0         8     12    16    20        24
///     ┌─────────┬─────┬─────┬─────┬─────────┐
///     │ seconds │  x  │  z  │  y  │ heading │
///     └─────────┴─────┴─────┴─────┴─────────┘
struct TrackRow {
  double seconds = 0.0;  ///< of the file's clock
  float x = 0.0F, z = 0.0F;
  float y = 0.0F;                                           ///< the ground below the feet
  float heading = std::numeric_limits<float>::quiet_NaN();  ///< radians from +Z towards +X; NaN: the file has none
};
static_assert(sizeof(TrackRow) == 24);
static_assert(offsetof(TrackRow, x) == 8 && offsetof(TrackRow, y) == 16 && offsetof(TrackRow, heading) == 20);

/// A person's rows, in ascending time, at least one but for a live crowd.
struct PersonTrack {
  std::string id;        ///< as the file has it
  float stature = 0.0F;  ///< metres, where the file has heights of heads; 0: it says nothing
  std::vector<TrackRow> rows;
};

/// The things that a reader of trajectories finds odd, without refusing the file.
enum class TrackOddity : std::uint8_t {
  bad_row,    ///< skipped, with --lenient
  duplicate,  ///< a person has two rows at one time; the last one counts
  gap,        ///< a person has no row for longer than three rows of others
  teleport,   ///< a person goes faster than 12 metres a second
  overlap,    ///< two people stand on each other: closer than 0.1 metres; each pair counts once; a crowd of more
              ///< than 150,000 rows is searched in some of its frames
};

/// Counts how often an oddity was found, and says where first.
struct OddityCount {
  TrackOddity oddity{};
  std::size_t count = 0;
  std::string first;  ///< "person 7 at 3.20 s: 4.1 m in 0.04 s"
};

/// All oddities that were found, each kind at most once, in the order of TrackOddity.
struct TrackReport {
  std::vector<OddityCount> found;
};

/// A recorded or simulated crowd, as plain data.
struct Trajectories {
  std::vector<PersonTrack> persons;                ///< by the time of their first rows, then in the order of the file
  GroundPlan plan;                                 ///< walls and floors, in the same axes and about the same origin
  glm::dvec2 origin{0.0};                          ///< metres: the file's (x, y) of the place (0, 0) here
  double rows_a_second = 0.0;                      ///< of most people; 0 where no person has two rows
  double first_seconds = 0.0, last_seconds = 0.0;  ///< of all rows
  std::size_t row_count = 0;
  std::string file;                  ///< as it was named; "-" for standard input
  TrackReading reading;              ///< how it was asked to be read
  std::string format;                ///< "JuPedSim SQLite", for people
  std::vector<std::string> remarks;  ///< sentences on findings of the reader: unit, frame rate, heights, doubts
  TrackReport report;
  /// Rows still come. `persons` are places then, each taken by a person who is there or was there, or free: LiveCrowd.
  bool is_live = false;
};

}  // namespace throng
