#include "engine/render/scenery/scenery_pass.h"

#include <cassert>
#include <cstddef>

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

}  // namespace

SceneryPass::SceneryPass(ShaderLibrary& shaders)
    : surface_(shaders.load({"scenery.vert", "scenery.frag"})),
      depth_(shaders.load({"scenery_depth.vert", "scenery_depth.frag"})) {}

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
      runs.push_back({static_cast<std::uint32_t>(indices.size()), static_cast<std::uint32_t>(lod.indices.size())});
      indices.insert(indices.end(), lod.indices.begin(), lod.indices.end());
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
  for (const SceneryShape& shape : shapes_) runs += shape.errors.size();
  commands_.assign(runs, {});
  chosen_.upload(order);  // makes room for as many as there are
}

DrawCounts SceneryPass::draw_chosen() {
  DrawCounts counts;
  std::size_t command = 0;
  for (const ScenerySelection::Run& run : selection_.runs()) {
    const LodRun& lod = lods_[run.mesh][run.lod];
    commands_[command++] = {lod.index_count, run.count, lod.first_index, first_vertices_[run.mesh], run.first};
    counts.triangles += std::uint64_t{lod.index_count / 3} * run.count;
  }
  if (command == 0) return counts;
  chosen_.upload(selection_.chosen());
  command_buffer_.upload(std::span(commands_.data(), command));
  glBindVertexArray(array_.id());
  glVertexArrayVertexBuffer(array_.id(), instance_stream, chosen_.id(), 0, sizeof(std::uint32_t));
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, scenery_binding, instances_.id());
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, command_buffer_.id());
  glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr, static_cast<GLsizei>(command),
                              sizeof(DrawCommand));
  counts.draw_calls = 1;
  return counts;
}

DrawCounts SceneryPass::draw(const CameraView& camera, float picture_height) {
  if (commands_.empty()) return {};
  selection_.choose(SceneryView(camera, picture_height));
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);  // depth is reversed
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glUseProgram(surface_.id());
  return draw_chosen();
}

DrawCounts SceneryPass::draw_depth(const glm::mat4& view_projection, float texel_metres) {
  if (commands_.empty()) return {};
  selection_.choose(SceneryView(view_projection, texel_metres), 1);
  glUseProgram(depth_.id());
  glUniformMatrix4fv(depth_matrix_location, 1, GL_FALSE, glm::value_ptr(view_projection));
  return draw_chosen();
}

}  // namespace throng::render
