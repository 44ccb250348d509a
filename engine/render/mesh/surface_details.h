#pragma once

#include "throng/render/crowd_mesh_data.h"

#include "engine/render/mesh/surface.h"

namespace throng::render {

/// Appends details that only some characters have: texture coordinates that differ from the base colour's,
/// and tangents. `surface` has none yet. One a vertex is added, in the order of for_each_part(); none where no part has
/// any.
void append_details(const CrowdMeshData& data, Surface& surface);

}  // namespace throng::render
