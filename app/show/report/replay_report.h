#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace throng::app {

/// The speeds at which a replay can be seen; 1 is the speed of the recording.
inline constexpr std::array<float, 5> replay_speeds = {0.25F, 0.5F, 1.0F, 2.0F, 4.0F};

/// All that the overlay shows of a replay.
struct ReplayReport {
  std::uint64_t frame = 0;                   ///< the frame that is shown, from 1
  std::uint64_t frames = 0;                  ///< in the recording
  std::optional<std::uint64_t> sought = {};  ///< the frame that the replay is on its way to
  bool paused = false;
  bool loops = false;  ///< at its end it begins anew
  float speed = 1.0F;
  bool ended = false;        ///< it goes no further
  bool differs = false;      ///< because a frame is not as it was recorded
  std::string outcome = {};  ///< says how it ended, once it did
};

}  // namespace throng::app
