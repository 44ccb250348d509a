// Trajectories in any text, XML and database; and the same text as it comes through a pipe.

#include <vector>

#include <unistd.h>

#include "engine/tracks/live/live_tracks.h"
#include "engine/tracks/read.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/fuzz/target.h"

namespace throng::fuzz {
namespace {

/// A pipe holds so much before its writer waits.
constexpr std::size_t pipe_bytes = 65536;

void read_as_it_comes(const std::uint8_t* data, std::size_t size) {
  int ends[2];
  if (size > pipe_bytes || pipe(ends) != 0) return;
  if (write(ends[1], data, size) != static_cast<ssize_t>(size)) std::abort();
  close(ends[1]);
  {
    LiveTracks live(ends[0], {.lenient = true});
    std::vector<LiveRow> rows;
    while (live.take(rows)) usleep(20);
    static_cast<void>(live.head());
  }
  close(ends[0]);
}

/// Ends the fuzzing where people are not as every reader promises.
void check(const Trajectories& tracks) {
  if (tracks.persons.empty()) std::abort();
  for (const PersonTrack& person : tracks.persons) {
    if (person.rows.empty()) std::abort();
    for (std::size_t i = 1; i < person.rows.size(); ++i) {
      if (!(person.rows[i - 1].seconds < person.rows[i].seconds)) std::abort();
    }
  }
}

}  // namespace
}  // namespace throng::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace throng;
  static const fuzz::ScratchFile file("input.txt");
  file.put(data, size);
  if (const auto strict = read_trajectories(file.path(), {})) fuzz::check(*strict);
  const TrackReading lenient{.up = TrackUp::y, .angle = TrackAngle::radians, .lenient = true};
  if (const auto skipped = read_trajectories(file.path(), lenient)) fuzz::check(*skipped);
  static_cast<void>(looks_like_trajectories(file.path()));
  fuzz::read_as_it_comes(data, size);
  return 0;
}
