#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "engine/base/result.h"
#include "engine/tracks/reading.h"
#include "engine/tracks/trajectories.h"

namespace throng {

/// A row as it came.
struct LiveRow {
  std::uint32_t person = 0;  ///< counts people in the order in which they come: LiveTracks::id()
  float stature = 0.0F;      ///< metres, where rows have heights of heads; 0: they have none
  TrackRow row;              ///< about LiveHead::origin
};

/// Holds the facts that are known once the first row is there.
struct LiveHead {
  glm::dvec2 origin{0.0};  ///< metres: the place of the first row, in whole metres
  TrackReading reading;    ///< how the rows were asked to be read
  std::string format;
  std::vector<std::string> remarks;
};

/// Reads rows as they come, from a pipe, a socket or a file: tables with a header, the text of the Jülich archive, JSON
/// lines and the XML of SUMO. A thread of its own waits for them and reads them, so that the caller never does. It
/// reads no further while most_waiting_rows wait to be taken, so that their sender waits too.
class LiveTracks {
 public:
  /// Starts to read. The descriptor stays the caller's, and is open for as long as this lives.
  LiveTracks(int descriptor, const TrackReading& options, std::string name = "-");
  ~LiveTracks();
  LiveTracks(const LiveTracks&) = delete;
  LiveTracks& operator=(const LiveTracks&) = delete;

  static constexpr std::size_t most_waiting_rows = 200'000;

  /// Adds the rows that came since the last call to `rows`. A person's rows ascend in time. Does not wait.
  /// Returns false once the last row was taken, because the text has ended or is wrong.
  bool take(std::vector<LiveRow>& rows);
  /// Waits until rows can be taken or the text ends, at most `most`.
  void wait(std::chrono::milliseconds most) const;
  /// Returns whether no more rows will come after the waiting ones.
  bool has_ended() const;
  std::optional<LiveHead> head() const;  ///< nothing before the first row
  std::string id(std::uint32_t person) const;
  /// Returns the fault that ended the text; the sentence begins with its name.
  Status status() const;
  std::size_t bad_rows() const;   ///< skipped, because options.lenient is set
  std::size_t late_rows() const;  ///< left out, because their person had a row at that time or later

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace throng
