#pragma once

#include "throng/character.h"
#include "throng/render/crowd_mesh_data.h"
#include "throng/result.h"

namespace throng {

/// Returns the surface of a character as render::Renderer::load_characters takes it, with poses of its clips in which
/// mesh LODs are measured. Its spans point into the character. Takes a moment.
/// Errors: the character was loaded without LoadOptions::keep_meshes, or has no surface.
Result<render::CrowdMeshData> mesh_data(const Character& character);

}  // namespace throng
