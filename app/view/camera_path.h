#pragma once

#include "app/settings/settings.h"
#include "engine/render/camera.h"

namespace throng::app {

/// Where a camera that stood at `start` has come to after so many seconds: around the middle of the scene, a turn a
/// minute; or turning in place, 30 degrees to each side, there and back in ten seconds.
render::Camera along(CameraPath path, const render::Camera& start, double seconds);

}  // namespace throng::app
