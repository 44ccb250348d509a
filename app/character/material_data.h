#pragma once

#include <string>

#include "engine/anim/asset/model.h"
#include "engine/anim/import/import.h"
#include "engine/render/crowd_mesh_data.h"

namespace throng::app {

/// Imports as import::import_file() does, with the channels that part_data() hands to drawing.
anim::Result<anim::ImportedFile> import_to_draw(const std::string& path, import::ImportOptions options = {});

/// Describes a mesh for drawing, with the coordinates that the textures of its material read. Points to the mesh.
render::MeshPartData part_data(const anim::SkinnedMesh& mesh, const anim::Material& material);

render::MaterialData material_data(const anim::Material& material);

}  // namespace throng::app
