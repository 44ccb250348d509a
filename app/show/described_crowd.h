#pragma once

#include "app/settings/preset.h"
#include "app/show/request/crowd_file.h"

namespace throng::app {

class Show;

/// Describes all that is open in a show, as a crowd file and the copied command line hold it. `seen` has the values
/// that a person asks for, and the place of the camera, which is left out where the setup says what moves the camera.
/// The window adds what it alone keeps: the tunings to compare, and the bookmarks.
CrowdSetup described(const Show& show, const Preset& seen);

}  // namespace throng::app
