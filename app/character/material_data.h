#pragma once

#include "engine/anim/asset/model.h"
#include "engine/render/crowd_mesh_data.h"

namespace throng::app {

/// Describes a mesh for drawing, with the coordinates that the textures of its material read. Points to the mesh.
render::MeshPartData part_data(const anim::SkinnedMesh& mesh, const anim::Material& material);

render::MaterialData material_data(const anim::Material& material);

}  // namespace throng::app
