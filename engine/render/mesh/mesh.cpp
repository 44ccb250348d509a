#include "engine/render/mesh/mesh.h"

#include <utility>

#include "engine/render/frame/frame_data.h"
#include "engine/render/mesh/morph_table.h"

namespace throng::render {
namespace {

constexpr GLint vertex_count_location = 0;  // the same in every program of the crowd

// In the order of their locations in `shaders/crowd_vertex.glsl`; the region has the next location.
constexpr gl::FloatAttribute surface_attributes[] = {{3, GL_FLOAT, offsetof(SurfaceVertex, position)},
                                                     {3, GL_FLOAT, offsetof(SurfaceVertex, normal)},
                                                     {2, GL_FLOAT, offsetof(SurfaceVertex, texture_coord)},
                                                     {4, GL_UNSIGNED_SHORT, offsetof(SurfaceVertex, color)},
                                                     {4, GL_UNSIGNED_SHORT, offsetof(SurfaceVertex, weights)},
                                                     {3, GL_BYTE, offsetof(SurfaceVertex, shape)},
                                                     {2, GL_BYTE, offsetof(SurfaceVertex, hair)}};
constexpr GLuint region_attribute = 7;
constexpr GLuint emission_coord_attribute = 8;

/// Describes coordinates of the emission's texture, which have a buffer of their own, or else are those of the base
/// colour.
void describe_emission_coords(const gl::VertexArray& array, const gl::Buffer& emission_coords) {
  const GLuint binding = emission_coords ? 1 : 0;
  const GLuint offset = emission_coords ? 0 : offsetof(SurfaceVertex, texture_coord);
  glVertexArrayAttribFormat(array.id(), emission_coord_attribute, 2, GL_FLOAT, GL_FALSE, offset);
  glVertexArrayAttribBinding(array.id(), emission_coord_attribute, binding);
  glEnableVertexArrayAttrib(array.id(), emission_coord_attribute);
  if (!emission_coords) return;
  glVertexArrayVertexBuffer(array.id(), binding, emission_coords.id(), 0, sizeof(EmissionCoord));
}

gl::VertexArray describe_vertices(const gl::Buffer& vertices, const gl::Buffer& indices,
                                  const gl::Buffer& emission_coords) {
  gl::VertexArray array = gl::create_vertex_array(surface_attributes, vertices, sizeof(SurfaceVertex));
  describe_emission_coords(array, emission_coords);
  glVertexArrayAttribIFormat(array.id(), region_attribute, 1, GL_UNSIGNED_BYTE, offsetof(SurfaceVertex, region));
  glVertexArrayAttribBinding(array.id(), region_attribute, 0);
  glEnableVertexArrayAttrib(array.id(), region_attribute);
  glVertexArrayElementBuffer(array.id(), indices.id());
  return array;
}

gl::Buffer create_entries(std::span<const std::vector<PaletteEntries>> by_level) {
  std::vector<PaletteEntries> all;
  for (const std::vector<PaletteEntries>& level : by_level) all.insert(all.end(), level.begin(), level.end());
  return gl::create_buffer(all.data(), all.size() * sizeof(PaletteEntries));
}

/// Makes a buffer that is never empty, because a storage block may not be.
gl::Buffer create_packing_frames(std::vector<PackingFrameData> frames) {
  if (frames.empty()) frames.emplace_back();
  return gl::create_buffer(frames.data(), frames.size() * sizeof(PackingFrameData));
}

}  // namespace

Result<CrowdMesh> CrowdMesh::create(const CrowdMeshData& data) {
  CrowdMesh mesh;
  Result<MaterialSet> materials = MaterialSet::create(data);
  if (!materials) return materials.error();
  mesh.materials_ = std::move(*materials);
  Surface surface = build_surface(data);
  mesh.vertices_ = gl::create_buffer(surface.vertices.data(), surface.vertices.size() * sizeof(SurfaceVertex));
  mesh.indices_ = gl::create_buffer(surface.indices.data(), surface.indices.size() * sizeof(std::uint32_t));
  mesh.palette_entries_ = create_entries(surface.entries_by_level);
  mesh.packing_frames_ = create_packing_frames(data.packing_frames);
  if (!surface.emission_coords.empty()) {
    mesh.emission_coords_ =
        gl::create_buffer(surface.emission_coords.data(), surface.emission_coords.size() * sizeof(EmissionCoord));
  }
  mesh.array_ = describe_vertices(mesh.vertices_, mesh.indices_, mesh.emission_coords_);
  mesh.create_morphs(data.morph_deltas, surface.vertices.size());
  surface.vertices = {};
  surface.emission_coords = {};
  surface.entries_by_level = {};
  surface.indices = {};
  mesh.surface_ = std::move(surface);
  return mesh;
}

void CrowdMesh::create_morphs(std::span<const MorphDeltaData> deltas, std::size_t vertex_count) {
  if (deltas.empty()) return;
  const MorphTable table = build_morph_table(deltas, vertex_count);
  morph_firsts_ = gl::create_buffer(table.firsts.data(), table.firsts.size() * sizeof(std::uint32_t));
  morph_entries_ = gl::create_buffer(table.entries.data(), table.entries.size() * sizeof(MorphEntry));
}

void CrowdMesh::bind() const {
  glBindVertexArray(array_.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, palette_entries_binding, palette_entries_.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, packing_frames_binding, packing_frames_.id());
  if (has_morphs()) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, morph_firsts_binding, morph_firsts_.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, morph_entries_binding, morph_entries_.id());
  }
  glUniform1ui(vertex_count_location, surface_.first_bone_end + surface_.bone_end_count);
}

}  // namespace throng::render
