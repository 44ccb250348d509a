#include "engine/render/mesh/surface.h"

#include <cassert>
#include <cmath>

#include <meshoptimizer.h>

#include "engine/render/mesh/mesh_lod.h"
#include "engine/render/mesh/mesh_parts.h"
#include "engine/render/mesh/surface_details.h"

namespace throng::render {
namespace {

constexpr float unorm16 = 65535.0F;

std::uint16_t to_unorm16(float value) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * unorm16));
}

void store_shares(std::span<const float> shares, std::size_t vertex, std::span<std::int8_t> stored) {
  if (shares.empty()) return;
  for (std::size_t i = 0; i < stored.size(); ++i) {
    const float share = std::clamp(shares[vertex * stored.size() + i], -1.0F, 1.0F);
    stored[i] = static_cast<std::int8_t>(std::lround(share * 127.0F));
  }
}

/// Rounds weights and keeps their sum one: the strongest takes the remainder.
void store_weights(std::span<const float> weights, std::uint16_t* stored) {
  int sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    stored[i] = to_unorm16(weights[i]);
    sum += stored[i];
  }
  std::uint16_t& strongest = *std::max_element(stored, stored + 4);
  strongest = static_cast<std::uint16_t>(strongest + static_cast<int>(unorm16) - sum);
}

SurfaceVertex vertex_of(const MeshPartData& part, std::size_t i) {
  SurfaceVertex vertex{};
  std::copy_n(&part.positions[i * 3], 3, vertex.position);
  std::copy_n(&part.normals[i * 3], 3, vertex.normal);
  if (!part.texture_coords.empty()) std::copy_n(&part.texture_coords[i * 2], 2, vertex.texture_coord);
  for (std::size_t c = 0; c < 4; ++c) {
    vertex.color[c] = part.colors.empty() ? static_cast<std::uint16_t>(unorm16) : to_unorm16(part.colors[i * 4 + c]);
  }
  store_weights(part.weights.subspan(i * 4, 4), vertex.weights);
  vertex.region = part.regions.empty() ? untinted_region : part.regions[i];
  store_shares(part.shapes, i, vertex.shape);
  store_shares(part.hair, i, vertex.hair);
  store_shares(part.faces, i, vertex.face);
  if (!part.trims.empty()) vertex.trim = static_cast<std::uint8_t>(to_unorm16(part.trims[i]) >> 8U);
  return vertex;
}

/// Holds the merged vertices, and the data of each that building the surface needs.
struct Merged {
  std::vector<float> positions;
  std::vector<std::uint32_t> indices;
  std::vector<int> materials;                   ///< one a vertex
  std::vector<float> texture_coords;            ///< one a vertex, or empty: no part shows a texture
  std::vector<std::uint32_t> belongs_to;        ///< material and tint region, one a vertex
  std::vector<glm::vec3> colors;                ///< one a vertex, as seen; or empty, before they are needed
  std::vector<std::uint8_t> face;               ///< one a vertex, 1 on a face; or empty: no face is known
  std::vector<SkinInfluences> influences;       ///< one a vertex
  std::vector<PaletteEntries> palette_entries;  ///< at level 0; including the bone ends' entries
};

/// Returns whether bones of a face move the vertex more than others do.
bool is_on_face(const SkinInfluences& influences, std::span<const std::uint8_t> face_entries) {
  float share = 0.0F;
  for (std::size_t i = 0; i < influences.entries.size(); ++i) {
    if (face_entries[influences.entries.at(i)] != 0) share += influences.weights.at(i);
  }
  return share > 0.5F;
}

void find_faces(const CrowdMeshData& data, Merged& merged) {
  if (data.face_entries.empty()) return;
  for (const SkinInfluences& influences : merged.influences) {
    merged.face.push_back(is_on_face(influences, data.face_entries) ? 1 : 0);
  }
}

void append_part(const MeshPartData& part, Surface& surface, Merged& merged) {
  const std::size_t count = part.positions.size() / 3;
  assert(part.normals.size() == count * 3 && part.weights.size() == count * 4 &&
         part.palette_entries.size() == count * 4);
  const auto first = static_cast<std::uint32_t>(surface.vertices.size());
  for (std::size_t i = 0; i < count; ++i) {
    surface.vertices.push_back(vertex_of(part, i));
    SkinInfluences influences{};
    std::copy_n(&part.palette_entries[i * 4], 4, influences.entries.begin());
    std::copy_n(&part.weights[i * 4], 4, influences.weights.begin());
    merged.influences.push_back(influences);
    merged.palette_entries.push_back(influences.entries);
    merged.belongs_to.push_back(static_cast<std::uint32_t>(part.material) << 8U | surface.vertices.back().region);
  }
  merged.positions.insert(merged.positions.end(), part.positions.begin(), part.positions.end());
  merged.materials.insert(merged.materials.end(), count, part.material);
  for (const std::uint32_t index : part.indices) {
    assert(index < count);
    merged.indices.push_back(first + index);
  }
}

void append_bone_ends(std::span<const BoneEndData> ends, Surface& surface, Merged& merged) {
  surface.first_bone_end = static_cast<std::uint32_t>(surface.vertices.size());
  surface.bone_end_count = static_cast<std::uint32_t>(ends.size());
  for (const BoneEndData& end : ends) {
    SurfaceVertex vertex{};
    std::copy_n(end.position, 3, vertex.position);
    vertex.normal[1] = 1.0F;
    vertex.weights[0] = static_cast<std::uint16_t>(unorm16);
    vertex.region = untinted_region;
    surface.vertices.push_back(vertex);
    merged.palette_entries.push_back({end.palette_entry, 0, 0, 0});
  }
}

std::vector<float> texture_coords_of(std::span<const SurfaceVertex> vertices) {
  std::vector<float> coords;
  coords.reserve(vertices.size() * 2);
  for (const SurfaceVertex& vertex : vertices)
    coords.insert(coords.end(), vertex.texture_coord, vertex.texture_coord + 2);
  return coords;
}

bool shows_an_image(const MaterialData& material) {
  return material.base_color_texture.image >= 0 || material.emission_texture.image >= 0;
}

SkinnedSurfaceView view_of(const Merged& merged) {
  return {.positions = merged.positions,
          .influences = merged.influences,
          .belongs_to = merged.belongs_to,
          .indices = merged.indices,
          .texture_coords = merged.texture_coords,
          .colors = merged.colors,
          .face = merged.face};
}

/// Appends one mesh LOD to the indices of the surface, sorted by the material of each triangle's first vertex. Parts
/// share no vertices, so only clustering can mix materials in a triangle.
void append_lod(std::span<const std::uint32_t> lod, std::span<const int> materials, int material_count,
                std::vector<std::uint32_t>& indices, SurfacePiece& piece) {
  std::vector<MaterialRun>& runs = piece.runs_by_level.emplace_back();
  std::vector<std::uint32_t> of_material;
  for (int material = 0; material < material_count; ++material) {
    of_material.clear();
    for (std::size_t i = 0; i < lod.size(); i += 3) {
      if (materials[lod[i]] != material) continue;
      of_material.insert(of_material.end(), lod.begin() + static_cast<std::ptrdiff_t>(i),
                         lod.begin() + static_cast<std::ptrdiff_t>(i + 3));
    }
    if (of_material.empty()) continue;
    meshopt_optimizeVertexCache(of_material.data(), of_material.data(), of_material.size(), materials.size());
    runs.push_back(
        {material, static_cast<std::uint32_t>(indices.size()), static_cast<std::uint32_t>(of_material.size())});
    indices.insert(indices.end(), of_material.begin(), of_material.end());
  }
  piece.triangles_by_level.push_back(static_cast<std::uint32_t>(lod.size() / 3));
}

/// Appends the vertices of baked LODs, and returns the mesh LODs with their errors.
std::vector<MeshLod> baked_lods(const CrowdMeshData& data, Surface& surface, Merged& merged) {
  std::vector<MeshLod> lods;
  const std::size_t full_count = merged.indices.size();
  lods.push_back({.indices = merged.indices});
  for (const BakedLodData& baked : used_baked_lods(data)) {
    const auto first = static_cast<std::ptrdiff_t>(merged.indices.size());
    for (const MeshPartData& part : baked.parts) append_part(part, surface, merged);
    lods.push_back({.indices = {merged.indices.begin() + first, merged.indices.end()}});
  }
  merged.indices.resize(full_count);
  find_faces(data, merged);
  const SurfacePaint paint(surface, merged.materials, data);
  measure_mesh_lods(lods, MeshErrorMeter(view_of(merged), &paint, data.poses));
  return lods;
}

std::vector<MeshLod> simplified_lods(const CrowdMeshData& data, const Surface& surface, Merged& merged) {
  find_faces(data, merged);
  const SurfacePaint paint(surface, merged.materials, data);
  for (std::uint32_t vertex = 0; vertex < merged.materials.size(); ++vertex) {
    merged.colors.push_back(paint.look({.vertices = {vertex, vertex, vertex}}).color);
  }
  return build_mesh_lods(view_of(merged), MeshErrorMeter(view_of(merged), &paint, data.poses));
}

SurfacePiece append_lods(const std::vector<MeshLod>& lods, const Merged& merged, const CrowdMeshData& data,
                         Surface& surface) {
  SurfacePiece piece;
  for (const MeshLod& lod : lods) {
    append_lod(lod.indices, merged.materials, static_cast<int>(data.materials.size()), surface.indices, piece);
    piece.error_by_level.push_back(lod.error);
  }
  return piece;
}

/// Returns the stated errors of the levels of a piece; on faces too, where the piece lies on a face.
MeshError stated_error(float error, const Merged& merged) {
  const bool face_is_known = !merged.face.empty();
  const bool on_face = std::ranges::find(merged.face, 1) != merged.face.end();
  return {error, !face_is_known || on_face ? error : 0.0F};
}

/// Merges all levels of a piece as they are stated.
std::vector<MeshLod> stated_lods(const CrowdMeshData& data, const MeshPieceData& piece, Surface& surface,
                                 Merged& merged) {
  std::vector<MeshLod> lods;
  for (std::size_t level = 0; level < piece.levels.size(); ++level) {
    if (repeats_the_level_before(piece, level)) {
      lods.push_back({.indices = lods.back().indices});
      continue;
    }
    const auto first = static_cast<std::ptrdiff_t>(merged.indices.size());
    for (const MeshPartData& part : piece.levels[level].parts) append_part(part, surface, merged);
    lods.push_back({.indices = {merged.indices.begin() + first, merged.indices.end()}});
  }
  find_faces(data, merged);
  for (std::size_t level = 0; level < lods.size(); ++level) {
    lods[level].error = stated_error(piece.levels[level].error, merged);
  }
  return lods;
}

std::vector<MeshLod> lods_of_piece(const CrowdMeshData& data, const MeshPieceData& piece, Surface& surface,
                                   Merged& merged) {
  if (piece.levels.size() > 1 || piece.is_silhouette) return stated_lods(data, piece, surface, merged);
  for (const MeshPartData& part : piece.levels.front().parts) append_part(part, surface, merged);
  merged.texture_coords = texture_coords_of(surface.vertices);  // of patterns, too
  return simplified_lods(data, surface, merged);
}

/// Builds a piece apart, and appends its vertices and indices to the surface.
SurfacePiece append_piece(const CrowdMeshData& data, const MeshPieceData& piece, Surface& surface, Merged& merged) {
  Surface own;
  Merged of_own;
  SurfacePiece appended = append_lods(lods_of_piece(data, piece, own, of_own), of_own, data, own);
  if (piece.is_silhouette) appended.first_lod = static_cast<std::uint32_t>(first_silhouette_lod);
  const auto first_vertex = static_cast<std::uint32_t>(surface.vertices.size());
  const auto first_index = static_cast<std::uint32_t>(surface.indices.size());
  surface.vertices.insert(surface.vertices.end(), own.vertices.begin(), own.vertices.end());
  for (const std::uint32_t index : own.indices) surface.indices.push_back(first_vertex + index);
  const std::vector<PaletteEntries>& entries = of_own.palette_entries;
  merged.palette_entries.insert(merged.palette_entries.end(), entries.begin(), entries.end());
  for (std::vector<MaterialRun>& runs : appended.runs_by_level) {
    for (MaterialRun& run : runs) run.first_index += first_index;
  }
  return appended;
}

/// Appends the entries that the vertices read at one bone level.
void append_entries(std::span<const PaletteEntries> entries, std::span<const std::uint16_t> entry_at_level,
                    std::vector<PaletteEntries>& all) {
  for (PaletteEntries of_vertex : entries) {
    for (std::uint16_t& entry : of_vertex) {
      assert(entry < entry_at_level.size());
      entry = entry_at_level[entry];
    }
    all.push_back(of_vertex);
  }
}

}  // namespace

SurfaceView view_of(const Surface& surface) {
  SurfaceView view;
  static_cast<SurfaceParts&>(view) = surface;
  view.vertices = surface.vertices;
  view.detail_coords = surface.detail_coords;
  view.tangents = surface.tangents;
  view.entries = surface.entries;
  view.indices = surface.indices;
  return view;
}

Surface build_surface(const CrowdMeshData& data) {
  Surface surface;
  Merged merged;
  for (const MeshPartData& part : data.parts) append_part(part, surface, merged);
  surface.vertex_count = static_cast<std::uint32_t>(surface.vertices.size());
  append_details(data, surface);
  if (std::ranges::any_of(data.materials, shows_an_image)) {
    merged.texture_coords = texture_coords_of(surface.vertices);
  }
  surface.pieces.push_back(
      append_lods(data.baked_lods.empty() ? simplified_lods(data, surface, merged) : baked_lods(data, surface, merged),
                  merged, data, surface));
  for (const MeshPieceData& piece : data.pieces) surface.pieces.push_back(append_piece(data, piece, surface, merged));
  append_bone_ends(data.bone_ends, surface, merged);
  if (!surface.detail_coords.empty()) surface.detail_coords.resize(surface.vertices.size());
  if (!surface.tangents.empty()) surface.tangents.resize(surface.vertices.size());
  for (const std::vector<std::uint16_t>& entry_at_level : data.entry_at_level) {
    append_entries(merged.palette_entries, entry_at_level, surface.entries);
  }
  return surface;
}

}  // namespace throng::render
