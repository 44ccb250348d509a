#pragma once

#include <string>
#include <vector>

#include "throng/render/camera.h"

#include "app/settings/settings.h"
#include "engine/base/result.h"

namespace throng::app {

/// Returns the place of a camera that began at `start`, after `seconds`. The orbit goes around the middle of the scene
/// once a minute. The pan turns in place, 30 degrees to each side, there and back in ten seconds.
render::Camera along(CameraPath path, const render::Camera& start, double seconds);

/// The place of a camera at a time.
struct CameraKey {
  double seconds = 0.0;  ///< since the path began
  CameraPose place;
};

/// Reads a camera path: a table with the header `time,x,y,z,yaw,pitch` or `time,x,y,z,yaw,pitch,fov`, and a row a key,
/// in ascending time. Numbers are seconds, and values of --camera. From a key to the next the camera turns by the
/// shorter way. Errors begin with the file's name, and name the line.
Result<std::vector<CameraKey>> read_camera_keys(const std::string& file);

/// Returns the camera after `seconds`. It passes every key smoothly, and stands still before the first and after the
/// last. There is at least one key.
render::Camera along(const std::vector<CameraKey>& keys, double seconds);

}  // namespace throng::app
