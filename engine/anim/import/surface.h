#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>

#include "engine/anim/asset/model.h"
#include "engine/anim/import/document.h"
#include "engine/anim/import/materials.h"

namespace throng::import {

/// Which morphs the targets of a primitive stand for, and how much of each target its surface shows at rest.
struct MorphsOfMesh {
  std::span<const double> rest_weights;
  std::vector<std::pair<int, std::uint32_t>> animated;  ///< target, index among Model::morphs; ascending
};

/// Reads positions, normals, tangents, colours, texture coordinates, tint regions, channels, triangles and material of
/// a primitive, adds its morph targets by their weights at rest, keeps animated targets as deltas, and moves all of it
/// by `placement`. Leaves influences empty, and normals where the file has none. Mends and reports NaN positions.
/// Throws Refusal, for infinite positions too.
anim::SkinnedMesh read_surface(Document& document, const tinygltf::Primitive& primitive, const MorphsOfMesh& morphs,
                               const glm::dmat4& placement, MaterialCollector& materials, const std::string& name);

}  // namespace throng::import
