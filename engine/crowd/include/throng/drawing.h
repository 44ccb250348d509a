#pragma once

#include <glm/vec2.hpp>

#include "throng/character.h"
#include "throng/crowd_view.h"
#include "throng/render/crowd_draw.h"
#include "throng/render/crowd_mesh_data.h"
#include "throng/result.h"

/// Leads from a CrowdView to throng::render.
namespace throng {

/// Returns the surface of a character as render::Renderer::load_characters takes it, with poses of its clips in which
/// mesh LODs are measured. Its spans point into the character. Takes a moment.
/// Errors: the character was loaded without LoadOptions::keep_meshes, or has no surface.
Result<render::CrowdMeshData> mesh_data(const Character& character);

/// Sets camera, matrices and size of a frame that is drawn from `eye` into a picture of `size` pixels.
void look_from(ViewFrame& frame, const render::CameraView& eye, glm::ivec2 size);

/// Returns the frame that shows these draws. Its spans are those of `draws`; looks, light and ground are the host's.
render::CrowdFrame crowd_frame(const render::CameraView& eye, const CrowdDraws& draws);

}  // namespace throng
