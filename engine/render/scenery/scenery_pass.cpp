#include "engine/render/scenery/scenery_pass.h"

#include <cassert>
#include <cstddef>

#include <glm/gtc/type_ptr.hpp>

#include "engine/render/frame/frame_data.h"
#include "engine/render/gl/device_errors.h"
#include "engine/render/light/light_parts.h"

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
    : surface_(shaders, {"scenery.vert", "scenery.frag"}, light_switches({"SHINY"})),
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
      LodRun& run = runs.emplace_back(LodRun{static_cast<std::uint32_t>(indices.size()), 0, 0});
      run.matt_count = add_triangles(mesh, lod, false, indices);
      run.shiny_count = add_triangles(mesh, lod, true, indices);
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

// A triangle mirrors if its first corner does. Processors that draw compute all of a program for each pixel, so most of
// a place must not be drawn with one that can mirror.
std::uint32_t SceneryPass::add_triangles(const SceneryMeshData& mesh, const SceneryLodData& lod, bool shiny,
                                         std::vector<std::uint32_t>& indices) const {
  std::uint32_t count = 0;
  for (std::size_t i = 0; i + 2 < lod.indices.size(); i += 3) {
    if ((mesh.vertices[lod.indices[i]].kind != SceneryKind::matt) != shiny) continue;
    indices.insert(indices.end(), {lod.indices[i], lod.indices[i + 1], lod.indices[i + 2]});
    count += 3;
  }
  return count;
}

void SceneryPass::upload_chosen() {
  chosen_.upload(selection_.chosen());
  glBindVertexArray(array_.id());
  glVertexArrayVertexBuffer(array_.id(), instance_stream, chosen_.id(), 0, sizeof(std::uint32_t));
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, scenery_binding, instances_.id());
}

DrawCounts SceneryPass::draw_chosen(Part part) {
  DrawCounts counts;
  std::size_t command = 0;
  for (const ScenerySelection::Run& run : selection_.runs()) {
    const LodRun& lod = lods_[run.mesh][run.lod];
    const std::uint32_t first = lod.first_index + (part == Part::shiny ? lod.matt_count : 0U);
    const std::uint32_t count =
        (part == Part::shiny ? 0U : lod.matt_count) + (part == Part::matt ? 0U : lod.shiny_count);
    if (count == 0) continue;
    commands_[command++] = {count, run.count, first, first_vertices_[run.mesh], run.first};
    counts.triangles += std::uint64_t{count / 3} * run.count;
  }
  if (command == 0) return counts;
  command_buffer_.upload(std::span(commands_.data(), command));
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, command_buffer_.id());
  glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr, static_cast<GLsizei>(command),
                              sizeof(DrawCommand));
  counts.draw_calls = 1;
  return counts;
}

DrawCounts SceneryPass::draw(const CameraView& camera, float picture_height, std::uint32_t light) {
  if (commands_.empty()) return {};
  selection_.choose(SceneryView(camera, picture_height));
  upload_chosen();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);  // depth is reversed
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glUseProgram(surface_.with(light).id());
  DrawCounts counts = draw_chosen(Part::matt);
  glUseProgram(surface_.with(light | 1U << light_part_count).id());
  add(counts, draw_chosen(Part::shiny));
  return counts;
}

DrawCounts SceneryPass::draw_depth(const glm::mat4& view_projection, float texel_metres) {
  if (commands_.empty()) return {};
  selection_.choose(SceneryView(view_projection, texel_metres), 1);
  upload_chosen();
  glUseProgram(depth_.id());
  glUniformMatrix4fv(depth_matrix_location, 1, GL_FALSE, glm::value_ptr(view_projection));
  return draw_chosen(Part::all);
}

}  // namespace throng::render
