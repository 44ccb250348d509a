#include "engine/anim/import/triangles.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include <glm/geometric.hpp>

#include "engine/anim/import/accessor_reader.h"
#include "engine/anim/import/refusal.h"

namespace throng::import {

namespace {

using Indices = std::vector<std::uint32_t>;

Indices read_indices(const Document& document, const tinygltf::Primitive& primitive, std::size_t vertex_count,
                     const std::string& name) {
  if (primitive.indices < 0) {
    Indices indices(vertex_count);
    std::iota(indices.begin(), indices.end(), 0U);
    return indices;
  }
  Indices indices =
      read_integers(document, primitive.indices,
                    {.what = name + ": indices",
                     .types = {TINYGLTF_TYPE_SCALAR},
                     .components = {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                                    TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT},
                     .raw = true});
  if (const auto largest = std::ranges::max(indices); largest >= vertex_count) {
    throw Refusal(name + ": index " + std::to_string(largest) + " of " + std::to_string(vertex_count) +
                  " vertices; export the file again");
  }
  return indices;
}

Indices unroll(const Indices& corners, bool is_fan) {
  Indices triangles;
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
  if (mode != TINYGLTF_MODE_TRIANGLES) return unroll(indices, mode == TINYGLTF_MODE_TRIANGLE_FAN);
  if (indices.size() % 3 != 0) {
    document.repairs.push_back(name + ": its last triangle is not whole, left out");
    indices.resize(indices.size() / 3 * 3);
  }
  return indices;
}

std::vector<glm::vec3> compute_normals(const std::vector<glm::vec3>& positions, const Indices& indices) {
  std::vector<glm::dvec3> sums(positions.size(), glm::dvec3(0.0));
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const glm::dvec3 a(positions[indices[i]]);
    const glm::dvec3 b(positions[indices[i + 1]]);
    const glm::dvec3 c(positions[indices[i + 2]]);
    const glm::dvec3 area = glm::cross(b - a, c - a);
    for (std::size_t corner = 0; corner < 3; ++corner) sums[indices[i + corner]] += area;
  }
  std::vector<glm::vec3> normals;
  normals.reserve(sums.size());
  for (const glm::dvec3& sum : sums) {
    const double length = glm::length(sum);
    normals.push_back(length > 0.0 ? glm::vec3(sum / length) : glm::vec3(0.0F, 1.0F, 0.0F));
  }
  return normals;
}

}  // namespace throng::import
