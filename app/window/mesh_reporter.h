#pragma once

#include <cstddef>

#include "app/show/report/frame_report.h"

namespace throng::app {

class Show;

/// Reports the meshes with which a character is drawn in the last drawn frame.
MeshReport report_meshes(const Show& show, std::size_t character);

}  // namespace throng::app
