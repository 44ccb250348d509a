#pragma once

#include <cstdint>
#include <vector>

#include "app/show/lod/mesh_choice.h"
#include "app/show/lod/mesh_lods.h"

namespace throng::app {

/// A mesh LOD of the character shown.
struct MeshLodRow {
  std::uint32_t triangles = 0;
  float error_mm = 0, face_error_mm = 0;
  float below_px = 0;  ///< height on screen below which it is drawn, where the error decides; infinity: always
  int agents = 0;      ///< in view, drawn with it
};

/// Reports the meshes with which the character shown is drawn, and the values that decide between them.
struct MeshReport {
  MeshTolerance tolerance;
  MeshFigures crowd;             ///< of all characters
  std::vector<MeshLodRow> lods;  ///< the full mesh first; empty where nothing is drawn
};

}  // namespace throng::app
