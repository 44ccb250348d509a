#include "tests/gl/skinning_read_back.h"

#include <stdexcept>

#include "engine/render/frame/frame_data.h"
#include "engine/render/mesh/mesh.h"

namespace throng::render::test {

SkinningReadBack::SkinningReadBack(Renderer& renderer)
    : renderer_(&renderer),
      shaders_(THRONG_SOURCE_DIR "/shaders"),
      program_(shaders_.load({.vertex = "skinning_read_back.vert",
                              .fragment = "",
                              .captured = {"world_position", "world_normal"},
                              .switches = {"MORPHED"}})) {
  if (!shaders_.status()) throw std::runtime_error(shaders_.status().error().message);
}

std::vector<ReadBackVertex> SkinningReadBack::read(const CrowdFrame& frame, const ReadBackAgent& agent) const {
  renderer_->upload(frame);
  // OpenGL captures no vertices without a framebuffer.
  target_.bind_overlay();
  const CrowdMesh& mesh = renderer_->meshes()[agent.character];
  std::vector<ReadBackVertex> vertices(mesh.vertex_count());
  const std::size_t bytes = vertices.size() * sizeof(ReadBackVertex);
  const gl::Buffer captured = gl::create_buffer(nullptr, bytes);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, captured.id());
  renderer_->bind_palette_page(agent.page, palette_binding);
  glUseProgram(program_.id());
  mesh.bind();
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_POINTS);
  glDrawArraysInstancedBaseInstance(GL_POINTS, 0, static_cast<GLsizei>(vertices.size()), 1, agent.instance);
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  glGetNamedBufferSubData(captured.id(), 0, static_cast<GLsizeiptr>(bytes), vertices.data());
  return vertices;
}

}  // namespace throng::render::test
