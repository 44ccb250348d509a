#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/anim/import/document.h"

namespace throng::import {

/// Returns the indices of a primitive as a list of triangles; unrolls strips and fans. Points and lines give none and a
/// report.
std::vector<std::uint32_t> read_triangles(Document& document, const tinygltf::Primitive& primitive,
                                          std::size_t vertex_count, const std::string& name);

}  // namespace throng::import
