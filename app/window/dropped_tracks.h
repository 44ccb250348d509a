#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/window/window_session.h"

namespace throng::app {

/// A recorded crowd that is to be read.
struct TracksToRead {
  std::string file, walls;  ///< `walls` may be empty
};

/// Returns the files to read of files that were dropped together: trajectories, walls, or both. `shown` is the
/// file of the crowd in the window, to which walls alone belong; empty: it is no recorded crowd. Returns nothing if no
/// file has trajectories or walls. Errors: they do not go together.
Result<std::optional<TracksToRead>> tracks_to_read(std::span<const std::string> files, const std::string& shown);

/// Opens recorded crowds that are dropped on a window. It names the files before it reads them, since that may take a
/// second.
class DroppedTracks {
 public:
  /// Takes files that were dropped together, if tracks_to_read() finds any, and says what will be read or why it cannot
  /// be. Returns whether it took them.
  bool takes(const std::vector<std::string>& files, WindowSession& session);
  /// Reads the taken files once they have been named. Call it after each frame was drawn.
  void read_when_said(WindowSession& session);

 private:
  void read(WindowSession& session) const;

  TracksToRead next_;
  bool begins_anew_ = false;   // it is no matter of walls alone
  int frames_until_read_ = 0;  // 0: nothing is to be read
};

}  // namespace throng::app
