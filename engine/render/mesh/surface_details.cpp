#include "engine/render/mesh/surface_details.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/render/mesh/mesh_parts.h"

namespace throng::render {
namespace {

bool has_detail_coords(const MeshPartData& part) {
  return !part.emission_coords.empty() || !part.metallic_roughness_coords.empty() || !part.normal_coords.empty() ||
         !part.occlusion_coords.empty();
}

bool has_tangents(const MeshPartData& part) { return !part.tangents.empty(); }

bool any_part(const CrowdMeshData& data, const auto& is_so) {
  bool any = false;
  for_each_part(data, [&](const MeshPartData& part) { any = any || is_so(part); });
  return any;
}

std::size_t vertex_count(const MeshPartData& part) { return part.positions.size() / 3; }

void append_detail_coords(const MeshPartData& part, Surface& surface) {
  const auto coord_at = [&part](std::span<const float> coords, std::size_t vertex) {
    const std::span<const float> used = coords.empty() ? part.texture_coords : coords;
    return used.empty() ? TextureCoord{} : TextureCoord{used[vertex * 2], used[vertex * 2 + 1]};
  };
  for (std::size_t i = 0; i < vertex_count(part); ++i) {
    surface.detail_coords.push_back({.emission = coord_at(part.emission_coords, i),
                                     .metallic_roughness = coord_at(part.metallic_roughness_coords, i),
                                     .normal = coord_at(part.normal_coords, i),
                                     .occlusion = coord_at(part.occlusion_coords, i)});
  }
}

void append_tangents(const MeshPartData& part, Surface& surface) {
  for (std::size_t i = 0; i < vertex_count(part); ++i) {
    PackedTangent packed{};
    for (std::size_t c = 0; c < packed.size() && has_tangents(part); ++c) {
      packed.at(c) = static_cast<std::int16_t>(std::lround(std::clamp(part.tangents[i * 4 + c], -1.0F, 1.0F) * 32767));
    }
    surface.tangents.push_back(packed);
  }
}

}  // namespace

void append_details(const CrowdMeshData& data, Surface& surface) {
  if (any_part(data, has_detail_coords)) {
    for_each_part(data, [&](const MeshPartData& part) { append_detail_coords(part, surface); });
  }
  if (any_part(data, has_tangents)) {
    for_each_part(data, [&](const MeshPartData& part) { append_tangents(part, surface); });
  }
}

}  // namespace throng::render
