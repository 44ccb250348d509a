#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "app/settings/settings.h"

namespace throng::app {

/// Places of the camera that a person keeps, at the keys 1 to 9.
inline constexpr std::size_t bookmark_count = 9;
using CameraBookmarks = std::array<std::optional<CameraPlace>, bookmark_count>;

/// All that the overlay shows of the cameras.
struct CameraReport {
  bool can_film = false;                    ///< a film or a path can move the camera by itself
  bool films = false;                       ///< it does so now
  bool follows = false;                     ///< the camera goes where the selected agent goes
  float fly_speed = 6;                      ///< metres a second
  std::array<bool, bookmark_count> kept{};  ///< [bookmark]
};

/// The commands about cameras that a person gives in a frame.
struct CameraCommands {
  bool home = false;                               ///< key Home: the scene's first camera; a film moves it again
  std::optional<std::size_t> named = {};           ///< of scene_camera_names
  bool change_follow = false;                      ///< key G: follow the selected agent, or no longer
  bool follow_behind = false;                      ///< Shift and G: go behind the selected agent and turn with it
  std::optional<float> fly_speed = {};             ///< metres a second
  std::optional<std::size_t> keep_bookmark = {};   ///< Ctrl and a digit
  std::optional<std::size_t> go_to_bookmark = {};  ///< a digit
};

}  // namespace throng::app
