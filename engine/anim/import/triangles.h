#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/anim/import/document.h"

namespace throng::import {

/// Indices of a primitive as a list of triangles, strips and fans unrolled; empty for points and lines, reported.
/// Throws Refusal.
std::vector<std::uint32_t> read_triangles(Document& document, const tinygltf::Primitive& primitive,
                                          std::size_t vertex_count, const std::string& name);

/// Unit normals, weighted by the area of the triangles around each vertex; +Y where there are none.
std::vector<glm::vec3> compute_normals(const std::vector<glm::vec3>& positions,
                                       const std::vector<std::uint32_t>& indices);

}  // namespace throng::import
