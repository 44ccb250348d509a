#pragma once

#include <cstdint>
#include <vector>

#include "app/show/lod/lod_export.h"
#include "engine/render/mesh/mesh.h"

namespace throng::app {

class Stage;

/// Returns the mesh LODs of a stage's character as its agents wear it: the largest error of any piece at each, and how
/// many triangles an agent is drawn with on average. An agent changes all of its pieces at once.
std::vector<MeshLevel> worn_levels(const Stage& stage, std::size_t character, const render::CrowdMesh& mesh);

}  // namespace throng::app
