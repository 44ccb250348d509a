#pragma once

#include <cstdint>
#include <string>

namespace throng::app {

/// Work that goes on beside the crowd. There is one of each kind at a time.
enum class SideJob : std::uint8_t { loading, video };

/// Tells how far a job is.
struct JobReport {
  SideJob job = SideJob::loading;
  std::string words;  ///< what it does now, such as "Knight.glb: clip 26 of 76"
  double share = -1;  ///< of it is done, 0 to 1; below 0: not known
};

}  // namespace throng::app
