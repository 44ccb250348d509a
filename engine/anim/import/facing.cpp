#include "engine/anim/import/facing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/base/elementary.h"

namespace throng::import {

namespace {

/// Returns the unit normal of a triangle, or +Y for one without area.
glm::vec3 triangle_normal(const std::vector<glm::vec3>& positions, const std::uint32_t* corners) {
  const glm::dvec3 a(positions[corners[0]]);
  const glm::dvec3 area = glm::cross(glm::dvec3(positions[corners[1]]) - a, glm::dvec3(positions[corners[2]]) - a);
  const double length = glm::length(area);
  return length > 0.0 ? glm::vec3(area / length) : glm::vec3(0.0F, 1.0F, 0.0F);
}

template <typename Value>
void pick(std::vector<Value>& values, const std::vector<std::uint32_t>& sources, std::size_t width = 1) {
  if (values.empty()) return;
  std::vector<Value> picked;
  picked.reserve(sources.size() * width);
  for (const std::uint32_t source : sources) {
    for (std::size_t i = 0; i < width; ++i) picked.push_back(values[source * width + i]);
  }
  values = std::move(picked);
}

/// Gives each vertex the deltas of the vertex that it is a copy of.
void pick_deltas(std::vector<anim::MorphDelta>& deltas, const std::vector<std::uint32_t>& sources) {
  if (deltas.empty()) return;
  std::vector<std::vector<anim::MorphDelta>> by_source(sources.size());  // at least as many as there were vertices
  for (const anim::MorphDelta& delta : deltas) by_source[delta.vertex].push_back(delta);
  deltas.clear();
  for (std::uint32_t vertex = 0; vertex < sources.size(); ++vertex) {
    for (anim::MorphDelta delta : by_source[sources[vertex]]) {
      delta.vertex = vertex;
      deltas.push_back(delta);
    }
  }
}

/// Replaces the vertices by copies of the vertices that `sources` names; leaves normals and indices.
void pick_vertices(anim::SkinnedMesh& mesh, const std::vector<std::uint32_t>& sources) {
  pick(mesh.positions, sources);
  for (auto& coords : mesh.texture_coords) pick(coords, sources);
  pick(mesh.colors, sources);
  pick(mesh.regions, sources);
  for (auto& channel : mesh.channels) pick(channel.values, sources, static_cast<std::size_t>(channel.components));
  pick(mesh.palette_entries, sources);
  pick(mesh.weights, sources);
  pick_deltas(mesh.morph_deltas, sources);
}

/// Returns the share of a vertex, 0 to 1, that mirrored entries move.
float mirrored_share(const anim::SkinnedMesh& mesh, std::uint32_t vertex, const std::vector<bool>& mirrored_entries) {
  float share = 0.0F;
  for (glm::length_t i = 0; i < 4; ++i) {
    if (mirrored_entries[mesh.palette_entries[vertex][i]]) share += mesh.weights[vertex][i];
  }
  return share;
}

/// How a triangle lies on its texture. In images v grows downwards, and green bumps point up (glTF 2.0, 3.9.3).
struct TextureSide {
  glm::dvec3 u{0.0};  ///< the direction in which u grows, unit; 0: the coordinates say none
  float side = 1.0F;  ///< of the bitangent; -1 where the texture is mirrored
};

TextureSide texture_side(const anim::SkinnedMesh& mesh, const std::vector<glm::vec2>& coords,
                         const std::uint32_t* corners) {
  const glm::dvec3 a(mesh.positions[corners[0]]);
  const glm::dvec3 ab = glm::dvec3(mesh.positions[corners[1]]) - a;
  const glm::dvec3 ac = glm::dvec3(mesh.positions[corners[2]]) - a;
  const glm::dvec2 uv_ab(coords[corners[1]] - coords[corners[0]]);
  const glm::dvec2 uv_ac(coords[corners[2]] - coords[corners[0]]);
  const double area = uv_ab.x * uv_ac.y - uv_ac.x * uv_ab.y;
  const glm::dvec3 u = (ab * uv_ac.y - ac * uv_ab.y) * (area < 0.0 ? -1.0 : 1.0);
  const double length = glm::length(u);
  if (area == 0.0 || !(length > 0.0)) return {};
  return {.u = u / length, .side = area > 0.0 ? -1.0F : 1.0F};
}

/// Returns the angle of a triangle's corner, of which `corner` is the index among the mesh's indices.
double angle_at(const anim::SkinnedMesh& mesh, std::size_t corner) {
  const std::size_t first = corner / 3 * 3;
  const auto edge_to = [&](std::size_t other) {
    return glm::dvec3(mesh.positions[mesh.indices[first + other % 3]]) -
           glm::dvec3(mesh.positions[mesh.indices[corner]]);
  };
  const glm::dvec3 a = edge_to(corner - first + 1), b = edge_to(corner - first + 2);
  return anim::arc_tangent(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Lets no vertex lie on a texture and on its mirror image: copies come last. Returns the side of each vertex.
std::vector<float> split_by_side(anim::SkinnedMesh& mesh, std::span<const TextureSide> triangles) {
  std::vector<float> sides(mesh.positions.size(), 0.0F);
  std::vector<std::uint32_t> copies(sides.size(), 0U), sources(sides.size());
  std::iota(sources.begin(), sources.end(), 0U);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const TextureSide& triangle = triangles[i / 3];
    const std::uint32_t vertex = mesh.indices[i];
    if (triangle.u == glm::dvec3(0.0)) continue;
    if (sides[vertex] == 0.0F) sides[vertex] = triangle.side;
    if (sides[vertex] == triangle.side) continue;
    if (copies[vertex] == 0U) {
      copies[vertex] = static_cast<std::uint32_t>(sources.size());
      sources.push_back(vertex);
      sides.push_back(triangle.side);
    }
    mesh.indices[i] = copies[vertex];
  }
  if (sources.size() > mesh.positions.size()) {
    pick(mesh.normals, sources);
    pick_vertices(mesh, sources);
  }
  return sides;
}

glm::vec4 tangent_of(const glm::dvec3& sum, float side, const glm::dvec3& normal) {
  const glm::dvec3 other = std::abs(normal.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  glm::dvec3 along = sum - normal * glm::dot(normal, sum);
  if (!(glm::length(along) > 0.0)) along = glm::cross(normal, other);
  return {glm::vec3(glm::normalize(along)), side < 0.0F ? -1.0F : 1.0F};
}

}  // namespace

void shade_flat(anim::SkinnedMesh& mesh) {
  constexpr float alike = 1e-4F;                // normals of triangles in one plane, which share their vertices
  constexpr std::ptrdiff_t most_compared = 64;  // copies; a fan has as many as triangles
  std::vector<std::uint32_t> sources(mesh.positions.size());
  std::iota(sources.begin(), sources.end(), 0U);
  std::vector<std::vector<std::uint32_t>> copies(sources.size());  // of each vertex, itself among them once it is used
  mesh.normals.assign(sources.size(), glm::vec3(0.0F, 1.0F, 0.0F));
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::vec3 normal = triangle_normal(mesh.positions, &mesh.indices[i]);
    for (std::size_t corner = i; corner < i + 3; ++corner) {
      const std::uint32_t vertex = mesh.indices[corner];
      const auto is_alike = [&](std::uint32_t copy) { return glm::distance(mesh.normals[copy], normal) < alike; };
      const auto last = copies[vertex].end();
      const auto same = std::find_if(last - std::min(most_compared, last - copies[vertex].begin()), last, is_alike);
      if (same != last) {
        mesh.indices[corner] = *same;
        continue;
      }
      mesh.indices[corner] = copies[vertex].empty() ? vertex : static_cast<std::uint32_t>(sources.size());
      copies[vertex].push_back(mesh.indices[corner]);
      if (mesh.indices[corner] == sources.size()) {
        sources.push_back(vertex);
        mesh.normals.push_back(normal);
      }
      mesh.normals[mesh.indices[corner]] = normal;
    }
  }
  pick_vertices(mesh, sources);
  mesh.tangents.clear();
}

std::vector<bool> mirrored_entries(const anim::Skeleton& skeleton) {
  std::vector<bool> mirrored;
  for (const glm::dmat4& entry : anim::reference_pose(skeleton, nullptr, 0.0).palette) {
    mirrored.push_back(glm::determinant(glm::dmat3(entry)) < 0.0);
  }
  return mirrored;
}

void turn_mirrored_triangles(anim::SkinnedMesh& mesh, const std::vector<bool>& mirrored_entries) {
  if (!std::ranges::count(mirrored_entries, true)) return;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    float share = 0.0F;
    for (std::size_t corner = i; corner < i + 3; ++corner) {
      share += mirrored_share(mesh, mesh.indices[corner], mirrored_entries) / 3.0F;
    }
    if (share > 0.5F) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  }
}

void add_tangents(anim::SkinnedMesh& mesh, const anim::Material& material) {
  if (material.normal_texture.image < 0) return;
  const auto& coords = mesh.texture_coords[static_cast<std::size_t>(material.normal_texture.coords)];
  if (coords.empty()) return;
  std::vector<TextureSide> triangles;
  triangles.reserve(mesh.indices.size() / 3);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    triangles.push_back(texture_side(mesh, coords, &mesh.indices[i]));
  }
  const std::vector<float> sides = split_by_side(mesh, triangles);
  std::vector<glm::dvec3> sums(sides.size(), glm::dvec3(0.0));
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const glm::dvec3 normal(mesh.normals[mesh.indices[i]]), &u = triangles[i / 3].u;
    const glm::dvec3 along = u - normal * glm::dot(normal, u);
    const double length = glm::length(along);
    if (length > 0.0) sums[mesh.indices[i]] += along * (angle_at(mesh, i) / length);
  }
  mesh.tangents.reserve(sums.size());
  for (std::size_t vertex = 0; vertex < sums.size(); ++vertex) {
    mesh.tangents.push_back(tangent_of(sums[vertex], sides[vertex], glm::dvec3(mesh.normals[vertex])));
  }
}

}  // namespace throng::import
