#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/tracks/file_plan.h"
#include "engine/tracks/huge_pages.h"
#include "engine/tracks/id_table.h"

namespace throng {

/// More people are refused.
inline constexpr std::size_t most_people = 100'000;
/// Places further from the middle of the file's world are refused, in metres.
inline constexpr double most_metres = 1e7;
/// Times further from 0 are refused: three hundred years in seconds, milliseconds of our days.
inline constexpr double most_time = 1e13;

/// A row as a file has it, in its own units.
struct RawRow {
  double time = 0.0;        ///< seconds, or frames
  double x = 0.0, y = 0.0;  ///< on the ground; y to the north
  float z = 0.0F;
  float angle = std::numeric_limits<float>::quiet_NaN();  ///< as AngleMeaning says
  std::uint32_t person = 0;                               ///< a number of an IdTable
};
static_assert(sizeof(RawRow) == 40);

using RawRows = std::vector<RawRow, HugePages<RawRow>>;

/// Returns TrackRow::heading of a direction on the ground, x to the east and y to the north; NaN for no direction. It
/// is within 0.00002 radians, in a fifth of the time of std::atan2.
inline float heading_of_direction(double x, double y) {
  if (x == 0.0 && y == 0.0) return std::numeric_limits<float>::quiet_NaN();
  const double across = std::abs(x), along = std::abs(y);
  const double ratio = std::min(across, along) / std::max(across, along), square = ratio * ratio;
  double angle =
      ratio * (0.99997726 +
               square * (-0.33262347 +
                         square * (0.19354346 + square * (-0.11643287 + square * (0.05265332 - square * 0.01172120)))));
  if (across > along) angle = std::numbers::pi / 2.0 - angle;
  if (y > 0.0) angle = std::numbers::pi - angle;  // north is -Z
  return static_cast<float>(x < 0.0 ? -angle : angle);
}

/// Rows that follow each other in a file.
struct RowBlock {
  RawRows rows;
  std::size_t table = 0;  ///< the table of RawTracks that their numbers come from
};

enum class AngleMeaning : std::uint8_t {
  none,
  unknown,  ///< counterclockwise from +x, degrees or radians
  degrees,  ///< counterclockwise from +x
  radians,  ///< counterclockwise from +x
  compass,  ///< degrees clockwise from north
  heading,  ///< TrackRow::heading itself
};

/// Frames a second where the file does not say it.
enum class RateRule : std::uint8_t {
  by_speed,   ///< 25, or 16 where people were too fast with 25
  annotated,  ///< as many as let people have 2.5 rows a second
};

/// Holds the facts about all rows that a format, or the head of a file, gives.
struct RowFacts {
  std::string format;
  bool has_frames = false;          ///< RawRow::time counts frames
  std::optional<double> rate = {};  ///< frames a second
  RateRule rate_rule = RateRule::by_speed;
  std::optional<double> unit = {};  ///< metres
  bool tells_unit = false;          ///< metres or centimetres are found where the file does not say; else metres
  double times_a_second = 1.0;      ///< of rows that have a time
  AngleMeaning angle = AngleMeaning::none;
  bool has_z = false;
  bool z_is_head = false;
  bool repeats_ends = false;  ///< a row at the time and place of the row before is no duplicate
  std::vector<std::string> remarks = {};
};

/// Takes the rows of one thread.
struct RowSink {
  RawRows rows;
  IdTable ids;
  double most = most_metres;  ///< the largest number of a place in the file's unit
  std::string fault = {};     ///< what is wrong with the last row: "\"abc\" is not a number; put x in metres there"
  double scene_rate = 0.0;    ///< rows a second of a person, where the file says it between rows
};

/// Adds a row whose numbers are finite. Returns false if the row is still wrong, after filling sink.fault.
bool add_row(const RawRow& row, RowSink& sink);

/// Takes the rows out of a sink, and makes room in it for about as many.
RawRows take_rows_of(RowSink& sink);

/// Reads the lines of a text. Each thread has one of its own.
class LineParser {
 public:
  virtual ~LineParser() = default;
  virtual std::unique_ptr<LineParser> copy() const = 0;
  /// Reads a line and adds the rows that it has, often one. Returns false if it is wrong, after filling sink.fault.
  virtual bool read(std::string_view line, RowSink& sink) = 0;
};

/// All of a file, in its own units.
struct RawTracks {
  RowFacts facts;
  std::vector<RowBlock> blocks;  ///< in the order of the file
  std::vector<IdTable> tables;
  FilePlan plan;
  std::size_t bad_rows = 0;
  std::string first_bad_row;
  double scene_rate = 0.0;
};

}  // namespace throng
