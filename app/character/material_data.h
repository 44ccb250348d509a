#pragma once

#include <vector>

#include "engine/anim/asset/model.h"
#include "engine/anim/import/import.h"
#include "engine/render/crowd_mesh_data.h"

namespace throng::app {

/// Imports as import::import_file() does, with the channels that part_data() hands to drawing.
Result<anim::ImportedFile> import_to_draw(const std::string& path, import::ImportOptions options = {});

/// Describes a mesh for drawing, with the coordinates that the textures of its material read. Points to the mesh.
render::MeshPartData part_data(const anim::SkinnedMesh& mesh, const anim::Material& material);

render::MaterialData material_data(const anim::Material& material);

/// Returns the changes that the model's morphs make to its surface, as drawing takes them.
std::vector<render::MorphDeltaData> morph_deltas(const anim::Model& model);

}  // namespace throng::app
