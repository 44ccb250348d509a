#pragma once

#include <span>
#include <string>

#include <glm/mat4x4.hpp>

#include "engine/anim/asset/model.h"
#include "engine/anim/import/document.h"
#include "engine/anim/import/materials.h"

namespace throng::import {

/// Reads positions, normals, tangents, colours, texture coordinates, tint regions, triangles and material of a
/// primitive, adds its morph targets by `morph_weights`, and moves all of it by `placement`. Leaves influences empty,
/// and normals where the file has none. Mends and reports NaN positions. Throws Refusal, for infinite positions too.
anim::SkinnedMesh read_surface(Document& document, const tinygltf::Primitive& primitive,
                               std::span<const double> morph_weights, const glm::dmat4& placement,
                               MaterialCollector& materials, const std::string& name);

}  // namespace throng::import
