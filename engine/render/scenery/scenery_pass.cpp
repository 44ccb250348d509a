#include "engine/render/scenery/scenery_pass.h"

#include <cstddef>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

#include "engine/render/frame/frame_data.h"
#include "engine/render/gl/device_errors.h"

namespace throng::render {
namespace {

constexpr GLint depth_matrix_location = 0;
constexpr GLuint instance_attribute = 4, instance_stream = 1;

constexpr gl::FloatAttribute scenery_attributes[] = {{3, GL_FLOAT, offsetof(SceneryVertex, position)},
                                                     {3, GL_FLOAT, offsetof(SceneryVertex, normal)},
                                                     {4, GL_UNSIGNED_BYTE, offsetof(SceneryVertex, color)},
                                                     {4, GL_UNSIGNED_BYTE, offsetof(SceneryVertex, glow)}};

/// An instance as the shader reads it; `shaders/scenery_instance.glsl` repeats the layout.
struct SceneryRecord {
  glm::mat4x3 place;
  std::uint32_t tint;
  std::uint32_t number;
};
static_assert(sizeof(SceneryRecord) == 56);

void add_triangles(const SceneryMeshData& mesh, const SceneryLodData& lod, bool matt,
                   std::vector<std::uint32_t>& indices) {
  for (std::size_t corner = 0; corner + 2 < lod.indices.size(); corner += 3) {
    if ((mesh.vertices[lod.indices[corner]].kind == SceneryKind::matt) != matt) continue;
    for (std::size_t i = 0; i < 3; ++i) indices.push_back(lod.indices[corner + i]);
  }
}

void test_scenery_depth() {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);  // depth is reversed
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
}

}  // namespace

SceneryPass::SceneryPass(ShaderLibrary& shaders)
    : matt_(shaders, {"scenery.vert", "scenery.frag"}, light_switches({"LIT_AT_VERTICES"})),
      mirror_(shaders, {"scenery.vert", "scenery_mirror.frag"}, light_switches()),
      own_depth_(shaders.load({"scenery.vert", "depth_only.frag"})),
      depth_(shaders.load({"scenery_depth.vert", "depth_only.frag"})) {}

Status SceneryPass::load(std::span<const SceneryMeshData> meshes) {
  std::vector<SceneryVertex> vertices;
  std::vector<std::uint32_t> indices;
  shapes_.clear();
  lods_.clear();
  first_vertices_.clear();
  for (const SceneryMeshData& mesh : meshes) {
    shapes_.push_back(shape_of(mesh));
    first_vertices_.push_back(static_cast<std::int32_t>(vertices.size()));
    vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    std::vector<LodRun>& runs = lods_.emplace_back();
    for (const SceneryLodData& lod : mesh.lods) {
      const auto first = static_cast<std::uint32_t>(indices.size());
      add_triangles(mesh, lod, true, indices);
      const auto matt_end = static_cast<std::uint32_t>(indices.size());
      add_triangles(mesh, lod, false, indices);
      runs.push_back({first, matt_end - first, static_cast<std::uint32_t>(indices.size()) - matt_end});
    }
  }
  vertices_ = gl::create_buffer(vertices.data(), vertices.size() * sizeof(SceneryVertex));
  indices_ = gl::create_buffer(indices.data(), indices.size() * sizeof(std::uint32_t));
  array_ = gl::create_vertex_array(scenery_attributes, vertices_, sizeof(SceneryVertex));
  glVertexArrayElementBuffer(array_.id(), indices_.id());
  glVertexArrayAttribIFormat(array_.id(), instance_attribute, 1, GL_UNSIGNED_INT, 0);
  glVertexArrayAttribBinding(array_.id(), instance_attribute, instance_stream);
  glVertexArrayBindingDivisor(array_.id(), instance_stream, 1);
  glEnableVertexArrayAttrib(array_.id(), instance_attribute);
  place({});
  return gl::take_errors("the scenery");
}

void SceneryPass::place(std::span<const SceneryInstance> instances) {
  const std::vector<std::uint32_t> order = selection_.place(instances, shapes_);
  std::vector<SceneryRecord> records;
  records.reserve(order.size());
  for (const std::uint32_t instance : order) {
    records.push_back({instances[instance].place, instances[instance].tint, instance});
  }
  instances_ = gl::create_buffer(records.data(), records.size() * sizeof(SceneryRecord));
  std::size_t runs = 0;
  for (const SceneryShape& shape : shapes_) runs += scenery_rings * shape.errors.size();
  commands_.assign(part_count * runs, {});
  chosen_.upload(order);  // makes room for as many as there are
}

// Makes the commands of the first `parts` parts for the chosen instances, and binds the buffers that they read.
void SceneryPass::compose(std::uint32_t parts) {
  std::uint32_t end = 0;
  for (std::uint32_t part = 0; part < part_count; ++part) {
    parts_.at(part) = end;
    triangles_.at(part) = 0;
    for (const ScenerySelection::Run& run : selection_.runs()) {
      const LodRun& lod = lods_[run.mesh][run.lod];
      const std::uint32_t first = lod.first_index + (part == mirrors ? lod.matt_count : 0);
      const std::uint32_t count = (part == mirrors ? 0 : lod.matt_count) + (part == matt ? 0 : lod.mirror_count);
      if (part >= parts || count == 0) continue;
      commands_[end++] = {count, run.count, first, first_vertices_[run.mesh], run.first};
      triangles_.at(part) += std::uint64_t{count / 3} * run.count;
    }
  }
  parts_.back() = end;
  if (end == 0) return;
  chosen_.upload(selection_.chosen());
  command_buffer_.upload(std::span(commands_.data(), end));
  glBindVertexArray(array_.id());
  glVertexArrayVertexBuffer(array_.id(), instance_stream, chosen_.id(), 0, sizeof(std::uint32_t));
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, scenery_binding, instances_.id());
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, command_buffer_.id());
}

DrawCounts SceneryPass::draw_part(Part part) const {
  const std::uint32_t first = parts_.at(part), count = parts_.at(part + 1U) - first;
  if (count == 0) return {};
  // OpenGL takes an offset into the bound buffer as a pointer.
  const void* const commands =
      reinterpret_cast<const void*>(std::uintptr_t{first} * sizeof(DrawCommand));  // NOLINT(performance-no-int-to-ptr)
  glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, commands, static_cast<GLsizei>(count),
                              sizeof(DrawCommand));
  return {1, triangles_.at(part)};
}

/// Draws depths alone. A draw that lights only equal depths then lights each point of the picture once.
DrawCounts SceneryPass::draw_own_depth() {
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glUseProgram(own_depth_.id());
  const DrawCounts counts = draw_part(whole);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  return counts;
}

DrawCounts SceneryPass::draw_depth_in_view(const CameraView& camera, float picture_height) {
  if (commands_.empty()) return {};
  selection_.choose(SceneryView(camera, picture_height));
  compose(1);
  test_scenery_depth();
  return draw_own_depth();
}

DrawCounts SceneryPass::draw(const CameraView& camera, float picture_height, std::uint32_t light) {
  if (commands_.empty()) return {};
  selection_.choose(SceneryView(camera, picture_height));
  compose(part_count);
  test_scenery_depth();
  DrawCounts counts;
  if ((light & shadow_part) != 0) {  // reading shadow maps costs more than another pass over the vertices
    counts = draw_own_depth();
    glDepthFunc(GL_EQUAL);
    glDepthMask(GL_FALSE);
  }
  for (const auto& [part, program] : {std::pair(matt, &matt_), std::pair(mirrors, &mirror_)}) {
    const std::uint32_t switches = part == matt ? light : light & ~scenery_lit_at_vertices;
    const bool has_srgb = (switches & scenery_lit_at_vertices) != 0;  // or the target makes it
    if (has_srgb) glDisable(GL_FRAMEBUFFER_SRGB);
    glUseProgram(program->with(switches).id());
    add(counts, draw_part(part));
    glEnable(GL_FRAMEBUFFER_SRGB);
  }
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  return counts;
}

DrawCounts SceneryPass::draw_depth(const glm::mat4& view_projection, float texel_metres) {
  if (commands_.empty()) return {};
  selection_.choose(SceneryView(view_projection, texel_metres), 1);
  compose(1);
  glUseProgram(depth_.id());
  glUniformMatrix4fv(depth_matrix_location, 1, GL_FALSE, glm::value_ptr(view_projection));
  return draw_part(whole);
}

}  // namespace throng::render
