#include "engine/render/mesh/mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string>

#include "engine/render/frame/frame_data.h"

namespace throng::render {
namespace {

constexpr GLint vertex_count_location = 0;  // the same in every program of the crowd

gl::Texture create_texture(const ImageData& image) {
  const auto mip_levels =
      static_cast<GLsizei>(std::bit_width(static_cast<unsigned>(std::max(image.width, image.height))));
  gl::Texture texture = gl::create_texture(GL_SRGB8_ALPHA8, image.width, image.height, mip_levels);
  const GLuint id = texture.id();
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

// In the order of their locations in `shaders/crowd_vertex.glsl`; the region has the next location.
constexpr gl::FloatAttribute surface_attributes[] = {{3, GL_FLOAT, offsetof(SurfaceVertex, position)},
                                                     {3, GL_FLOAT, offsetof(SurfaceVertex, normal)},
                                                     {2, GL_FLOAT, offsetof(SurfaceVertex, texture_coord)},
                                                     {4, GL_UNSIGNED_SHORT, offsetof(SurfaceVertex, color)},
                                                     {4, GL_UNSIGNED_SHORT, offsetof(SurfaceVertex, weights)},
                                                     {3, GL_BYTE, offsetof(SurfaceVertex, shape)},
                                                     {2, GL_BYTE, offsetof(SurfaceVertex, hair)}};
constexpr GLuint region_attribute = 7;

gl::VertexArray describe_vertices(const gl::Buffer& vertices, const gl::Buffer& indices) {
  gl::VertexArray array = gl::create_vertex_array(surface_attributes, vertices, sizeof(SurfaceVertex));
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
  mesh.array_ = describe_vertices(mesh.vertices_, mesh.indices_);
  surface.vertices = {};
  surface.entries_by_level = {};
  surface.indices = {};
  mesh.surface_ = std::move(surface);
  return mesh;
}

void CrowdMesh::bind() const {
  glBindVertexArray(array_.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, palette_entries_binding, palette_entries_.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, packing_frames_binding, packing_frames_.id());
  glUniform1ui(vertex_count_location, surface_.first_bone_end + surface_.bone_end_count);
}

}  // namespace throng::render
