#include "engine/anim/import/triangles.h"

#include <algorithm>
#include <numeric>

#include "engine/anim/import/accessors.h"
#include "engine/anim/import/bytes/refusal.h"
#include "engine/anim/import/memory/model_memory.h"

namespace throng::import {

namespace {

using Indices = std::vector<std::uint32_t>;

Indices read_indices(const Document& document, const tinygltf::Primitive& primitive, std::size_t vertex_count,
                     const std::string& name) {
  if (primitive.indices < 0) {
    document.memory->charge(vertex_count * sizeof(std::uint32_t), name);
    Indices indices(vertex_count);
    std::iota(indices.begin(), indices.end(), 0U);
    return indices;
  }
  Indices indices =
      read_integers(document, primitive.indices, {name + ": indices", {TINYGLTF_TYPE_SCALAR}, any_unsigned, true});
  if (const auto largest = std::ranges::max(indices); largest >= vertex_count) {
    refuse(name, "index " + std::to_string(largest) + " of " + std::to_string(vertex_count) + " vertices");
  }
  return indices;
}

Indices unroll(const Indices& corners, bool is_fan) {
  Indices triangles;
  triangles.reserve(corners.size() * 3);
  for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
    const bool odd = i % 2 == 1 && !is_fan;
    triangles.push_back(is_fan ? corners[0] : corners[i]);
    triangles.push_back(odd ? corners[i + 2] : corners[i + 1]);
    triangles.push_back(odd ? corners[i + 1] : corners[i + 2]);
  }
  return triangles;
}

}  // namespace

Indices read_triangles(Document& document, const tinygltf::Primitive& primitive, std::size_t vertex_count,
                       const std::string& name) {
  const int mode = primitive.mode;
  if (mode > TINYGLTF_MODE_TRIANGLE_FAN) throw Refusal(name + ": mode " + std::to_string(mode) + " is unknown");
  if (mode < TINYGLTF_MODE_TRIANGLES) {
    document.repairs.push_back(name + ": points or lines, left out");
    return {};
  }
  Indices indices = read_indices(document, primitive, vertex_count, name);
  document.memory->charge(bytes_of(indices) * 3, name);  // triangles of a strip or fan
  if (mode != TINYGLTF_MODE_TRIANGLES) return unroll(indices, mode == TINYGLTF_MODE_TRIANGLE_FAN);
  if (indices.size() % 3 != 0) {
    document.repairs.push_back(name + ": its last triangle is not whole, left out");
    indices.resize(indices.size() / 3 * 3);
  }
  return indices;
}

}  // namespace throng::import
