#pragma once

#include "app/report/viewer_report.h"
#include "app/show/show.h"
#include "app/view/fly_camera.h"
#include "app/view/input.h"

namespace throng::app {

/// Does what a person asks of the viewer of one character. Errors: the character cannot be shown alone.
anim::Status obey_viewer(Show& show, const ViewerCommands& commands);

}  // namespace throng::app
