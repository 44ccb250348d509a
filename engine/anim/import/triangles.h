#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/anim/import/document.h"

namespace throng::import {

/// Returns the indices of a primitive as a list of triangles; unrolls strips and fans. Points and lines give none and a
/// report. Throws Refusal.
std::vector<std::uint32_t> read_triangles(Document& document, const tinygltf::Primitive& primitive,
                                          std::size_t vertex_count, const std::string& name);

/// Returns unit normals, weighted by the area of the triangles around each vertex; +Y for a vertex without any.
std::vector<glm::vec3> compute_normals(const std::vector<glm::vec3>& positions,
                                       const std::vector<std::uint32_t>& indices);

}  // namespace throng::import
