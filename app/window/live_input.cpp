#include "app/window/live_input.h"

#include <chrono>

#include "app/files/progress_line.h"
#include "app/window/stop_signals.h"
#include "engine/base/files/process.h"

namespace throng::app {

anim::Result<std::unique_ptr<LiveTracks>> open_live_input(const DemoOptions& options) {
  if (options.trajectories.file != "-") return std::unique_ptr<LiveTracks>();
  auto tracks = std::make_unique<LiveTracks>(standard_input, options.trajectories.reading);
  show_progress("waiting for the first row on standard input");
  while (!tracks->head() && !tracks->has_ended() && asked_to_stop() == 0) tracks->wait(std::chrono::milliseconds(100));
  show_progress("");
  if (tracks->head()) return tracks;
  if (const Status read = tracks->status(); !read) return anim::Error{read.error().message};
  return anim::Error{asked_to_stop() != 0 ? "-: the run ends before the first row came"
                                          : "-: it ended without a row; send rows as a table with a header"};
}

}  // namespace throng::app
