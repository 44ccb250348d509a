#include "engine/render/mesh/mesh.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engine/render/frame/frame_data.h"
#include "engine/render/gl/device_limits.h"
#include "engine/render/mesh/mesh_lod.h"
#include "engine/render/mesh/morph_table.h"
#include "engine/render/mesh/packed_surface.h"

namespace throng::render {
namespace {

constexpr GLint vertex_count_location = 0, body_size_location = 5;  // the same in every program of the crowd

// In the order of their locations in `shaders/crowd_vertex.glsl`; the region has the next location.
constexpr gl::FloatAttribute surface_attributes[] = {{3, GL_FLOAT, offsetof(SurfaceVertex, position)},
                                                     {3, GL_FLOAT, offsetof(SurfaceVertex, normal)},
                                                     {2, GL_FLOAT, offsetof(SurfaceVertex, texture_coord)},
                                                     {4, GL_UNSIGNED_SHORT, offsetof(SurfaceVertex, color)},
                                                     {4, GL_UNSIGNED_SHORT, offsetof(SurfaceVertex, weights)},
                                                     {3, GL_BYTE, offsetof(SurfaceVertex, shape)},
                                                     {2, GL_BYTE, offsetof(SurfaceVertex, hair)}};
constexpr GLuint region_attribute = 7;
constexpr GLuint first_detail_coord_attribute = 8;  // in the order of DetailCoords
constexpr GLuint detail_coord_count = sizeof(DetailCoords) / sizeof(TextureCoord);
constexpr GLuint tangent_attribute = first_detail_coord_attribute + detail_coord_count;
constexpr GLuint trim_attribute = tangent_attribute + 1, face_attribute = tangent_attribute + 2;

/// Describes coordinates of textures over the base colour, which have a buffer of their own, or else are those of the
/// base colour.
void describe_detail_coords(const gl::VertexArray& array, const gl::Buffer& detail_coords) {
  const GLuint binding = detail_coords ? 1 : 0;
  for (GLuint i = 0; i < detail_coord_count; ++i) {
    const std::size_t offset = detail_coords ? i * sizeof(TextureCoord) : offsetof(SurfaceVertex, texture_coord);
    gl::describe(array, first_detail_coord_attribute + i, {2, GL_FLOAT, offset}, binding);
  }
  if (detail_coords) glVertexArrayVertexBuffer(array.id(), binding, detail_coords.id(), 0, sizeof(DetailCoords));
}

/// Describes tangents. Without them, shaders read 0 0 0 as the tangent.
void describe_tangents(const gl::VertexArray& array, const gl::Buffer& tangents) {
  constexpr GLuint binding = 2;
  if (!tangents) return;
  gl::describe(array, tangent_attribute, {4, GL_SHORT, 0}, binding);
  glVertexArrayVertexBuffer(array.id(), binding, tangents.id(), 0, sizeof(PackedTangent));
}

gl::VertexArray describe_vertices(const gl::Buffer& vertices, const gl::Buffer& indices) {
  gl::VertexArray array = gl::create_vertex_array(surface_attributes, vertices, sizeof(SurfaceVertex));
  glVertexArrayAttribIFormat(array.id(), region_attribute, 1, GL_UNSIGNED_BYTE, offsetof(SurfaceVertex, region));
  glVertexArrayAttribBinding(array.id(), region_attribute, 0);
  glEnableVertexArrayAttrib(array.id(), region_attribute);
  gl::describe(array, trim_attribute, {1, GL_UNSIGNED_BYTE, offsetof(SurfaceVertex, trim)});
  gl::describe(array, face_attribute, {4, GL_BYTE, offsetof(SurfaceVertex, face)});
  glVertexArrayElementBuffer(array.id(), indices.id());
  return array;
}

template <typename T>
gl::Buffer create_buffer_of(std::span<const T> elements) {
  return gl::create_buffer(elements.data(), elements.size_bytes());
}

/// Makes a buffer that is never empty, because a storage block may not be.
gl::Buffer create_packing_frames(std::vector<PackingFrameData> frames) {
  if (frames.empty()) frames.emplace_back();
  return gl::create_buffer(frames.data(), frames.size() * sizeof(PackingFrameData));
}

float longest_side(std::span<const SurfaceVertex> vertices) {
  float longest = 0.0F;
  for (std::size_t axis = 0; axis < 3 && !vertices.empty(); ++axis) {
    const auto [low, high] =
        std::ranges::minmax(vertices, {}, [axis](const SurfaceVertex& vertex) { return vertex.position[axis]; });
    longest = std::max(longest, high.position[axis] - low.position[axis]);
  }
  return longest;
}

constexpr float stretch_of_poses = 1.4F;

float farthest_from_origin(std::span<const SurfaceVertex> vertices) {
  float farthest = 0.0F;
  for (const SurfaceVertex& vertex : vertices) {
    const auto& [x, y, z] = vertex.position;
    farthest = std::max(farthest, x * x + y * y + z * z);
  }
  return std::sqrt(farthest);
}

Status check_morphs(const CrowdMeshData& data) {
  const std::size_t most = gl::ask_device_limits().storage_block / sizeof(MorphEntry);
  if (data.morph_deltas.size() <= most) return Done{};
  return Error{"the morphs of a character move " + std::to_string(data.morph_deltas.size()) +
               " vertices; this device takes " + std::to_string(most) + ", remove morphs"};
}

}  // namespace

Result<CrowdMesh> CrowdMesh::create(const CrowdMeshData& data) {
  if (const Status fits = check_morphs(data); !fits) return fits.error();
  CrowdMesh mesh;
  Result<MaterialSet> materials = MaterialSet::create(data);
  if (!materials) return materials.error();
  mesh.materials_ = std::move(*materials);
  mesh.body_size_ = data.body_size;
  mesh.packing_frames_ = create_packing_frames(data.packing_frames);
  if (data.packed_surface.empty()) {
    mesh.copy_to_device(view_of(build_surface(data)), data.morph_deltas);
    return mesh;
  }
  const Result<SurfaceView> packed = view_packed_surface(data.packed_surface);
  if (!packed) return packed.error();
  mesh.copy_to_device(*packed, data.morph_deltas);
  return mesh;
}

void CrowdMesh::copy_to_device(const SurfaceView& surface, std::span<const MorphDeltaData> morph_deltas) {
  vertices_ = create_buffer_of(surface.vertices);
  indices_ = create_buffer_of(surface.indices);
  palette_entries_ = create_buffer_of(surface.entries);
  if (!surface.detail_coords.empty()) detail_coords_ = create_buffer_of(surface.detail_coords);
  if (!surface.tangents.empty()) tangents_ = create_buffer_of(surface.tangents);
  array_ = describe_vertices(vertices_, indices_);
  describe_detail_coords(array_, detail_coords_);
  describe_tangents(array_, tangents_);
  create_morphs(morph_deltas, surface.vertices.size());
  parts_ = surface;
  reach_ = stretch_of_poses * farthest_from_origin(surface.vertices.first(parts_.vertex_count));
  reach_of_pieces_ = stretch_of_poses * farthest_from_origin(surface.vertices);
  longest_side_of_bones_ = longest_side(surface.vertices.subspan(parts_.first_bone_end, parts_.bone_end_count));
}

void CrowdMesh::create_morphs(std::span<const MorphDeltaData> deltas, std::size_t vertex_count) {
  if (deltas.empty()) return;
  const MorphTable table = build_morph_table(deltas, vertex_count);
  morph_firsts_ = create_buffer_of(std::span<const std::uint32_t>(table.firsts));
  morph_entries_ = create_buffer_of(std::span<const MorphEntry>(table.entries));
}

int CrowdMesh::coarsest_lod(std::size_t number, float metres) const {
  return static_cast<int>(piece(number).first_lod) + pick_mesh_lod(piece(number).error_by_level, {metres, metres});
}

void CrowdMesh::bind() const {
  glBindVertexArray(array_.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, palette_entries_binding, palette_entries_.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, packing_frames_binding, packing_frames_.id());
  if (has_morphs()) {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, morph_firsts_binding, morph_firsts_.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, morph_entries_binding, morph_entries_.id());
  }
  glUniform1ui(vertex_count_location, parts_.first_bone_end + parts_.bone_end_count);
  glUniform1f(body_size_location, body_size_);
}

}  // namespace throng::render
