#pragma once

#include "app/settings/settings.h"
#include "engine/render/camera.h"

namespace throng::app {

/// Returns the place of a camera that began at `start`, after `seconds`. The orbit goes around the middle of the scene
/// once a minute. The pan turns in place, 30 degrees to each side, there and back in ten seconds.
render::Camera along(CameraPath path, const render::Camera& start, double seconds);

}  // namespace throng::app
