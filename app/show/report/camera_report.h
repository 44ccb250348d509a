#pragma once

#include <array>

#include "app/show/camera/camera_bookmarks.h"

namespace throng::app {

/// All that the overlay shows of the cameras.
struct CameraReport {
  bool can_film = false;                    ///< a film or a path can move the camera by itself
  bool films = false;                       ///< it does so now
  bool follows = false;                     ///< the camera goes where the selected agent goes
  float fly_speed = 6;                      ///< metres a second
  std::array<bool, bookmark_count> kept{};  ///< [bookmark]
};

}  // namespace throng::app
