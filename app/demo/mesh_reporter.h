#pragma once

#include <cstddef>

#include "app/report/mesh_report.h"
#include "app/show/show.h"

namespace throng::app {

/// Reports what meshes a character is drawn with in the frame that was drawn last.
MeshReport report_meshes(const Show& show, std::size_t character);

}  // namespace throng::app
