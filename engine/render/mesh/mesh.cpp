#include "engine/render/mesh/mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string>

#include "engine/render/frame/frame_uniforms.h"
#include "engine/render/mesh/mesh_lod.h"

namespace throng::render {
namespace {

constexpr GLuint vertex_binding = 0;
constexpr GLint vertex_count_location = 0;  // the same in every program of the crowd

gl::Texture create_texture(const ImageData& image) {
  gl::Texture texture = gl::create_texture(GL_TEXTURE_2D);
  const GLuint id = texture.id();
  const auto mip_levels =
      static_cast<GLsizei>(std::bit_width(static_cast<unsigned>(std::max(image.width, image.height))));
  glTextureStorage2D(id, mip_levels, GL_SRGB8_ALPHA8, image.width, image.height);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(id, 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  glGenerateTextureMipmap(id);
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  return texture;
}

gl::Texture create_white() {
  constexpr std::array<std::uint8_t, 4> white = {255, 255, 255, 255};
  return create_texture({1, 1, white});
}

Status check_size(const ImageData& image, std::size_t index) {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  if (image.width <= limit && image.height <= limit) return Done{};
  return Error{"image " + std::to_string(index) + " is " + std::to_string(image.width) + "x" +
               std::to_string(image.height) + "; this device takes " + std::to_string(limit) + ", scale it down"};
}

struct FloatAttribute {
  SurfaceAttribute attribute;
  GLint size;
  GLenum type;
  GLuint offset;
};

constexpr std::array<FloatAttribute, 7> float_attributes = {{
    {SurfaceAttribute::position, 3, GL_FLOAT, offsetof(SurfaceVertex, position)},
    {SurfaceAttribute::normal, 3, GL_FLOAT, offsetof(SurfaceVertex, normal)},
    {SurfaceAttribute::texture_coord, 2, GL_FLOAT, offsetof(SurfaceVertex, texture_coord)},
    {SurfaceAttribute::color, 4, GL_UNSIGNED_SHORT, offsetof(SurfaceVertex, color)},
    {SurfaceAttribute::weights, 4, GL_UNSIGNED_SHORT, offsetof(SurfaceVertex, weights)},
    {SurfaceAttribute::shape, 3, GL_BYTE, offsetof(SurfaceVertex, shape)},
    {SurfaceAttribute::hair, 2, GL_BYTE, offsetof(SurfaceVertex, hair)},
}};

void describe_vertex(GLuint array) {
  for (const FloatAttribute& format : float_attributes) {
    const auto attribute = static_cast<GLuint>(format.attribute);
    glVertexArrayAttribFormat(array, attribute, format.size, format.type, GL_TRUE, format.offset);
    glVertexArrayAttribBinding(array, attribute, vertex_binding);
    glEnableVertexArrayAttrib(array, attribute);
  }
  constexpr auto region = static_cast<GLuint>(SurfaceAttribute::region);
  glVertexArrayAttribIFormat(array, region, 1, GL_UNSIGNED_BYTE, offsetof(SurfaceVertex, region));
  glVertexArrayAttribBinding(array, region, vertex_binding);
  glEnableVertexArrayAttrib(array, region);
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
  for (std::size_t i = 0; i < data.images.size(); ++i) {
    if (const Status fits = check_size(data.images[i], i); !fits) return fits.error();
    mesh.textures_.push_back(create_texture(data.images[i]));
  }
  mesh.textures_.push_back(create_white());
  for (const MaterialData& material : data.materials) {
    const gl::Texture& texture =
        material.image < 0 ? mesh.textures_.back() : mesh.textures_[static_cast<std::size_t>(material.image)];
    const float* color = material.base_color;
    mesh.materials_.push_back(
        {{color[0], color[1], color[2], color[3]}, texture.id(), material.double_sided, material.alpha_cutoff});
  }
  Surface surface = build_surface(data);
  mesh.vertices_ = gl::create_buffer(surface.vertices.data(), surface.vertices.size() * sizeof(SurfaceVertex));
  mesh.indices_ = gl::create_buffer(surface.indices.data(), surface.indices.size() * sizeof(std::uint32_t));
  mesh.palette_entries_ = create_entries(surface.entries_by_level);
  mesh.packing_frames_ = create_packing_frames(data.packing_frames);
  mesh.array_ = gl::create_vertex_array();
  const GLuint array = mesh.array_.id();
  describe_vertex(array);
  glVertexArrayVertexBuffer(array, vertex_binding, mesh.vertices_.id(), 0, sizeof(SurfaceVertex));
  glVertexArrayElementBuffer(array, mesh.indices_.id());
  mesh.runs_by_lod_ = std::move(surface.runs_by_lod);
  mesh.triangles_by_lod_ = std::move(surface.triangles_by_lod);
  mesh.error_by_lod_ = std::move(surface.error_by_lod);
  mesh.vertex_count_ = surface.vertex_count;
  mesh.first_bone_end_ = surface.first_bone_end;
  mesh.bone_end_count_ = surface.bone_end_count;
  return mesh;
}

void CrowdMesh::bind() const {
  glBindVertexArray(array_.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, palette_entries_binding, palette_entries_.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, packing_frames_binding, packing_frames_.id());
  glUniform1ui(vertex_count_location, first_bone_end_ + bone_end_count_);
}

int pick_mesh_lod(const CrowdMesh& mesh, float pixels_tall, int at_least, float detail) {
  return pick_mesh_lod(mesh.triangles_by_lod(), pixels_tall, at_least, detail);
}

}  // namespace throng::render
