#include "engine/render/passes/line_pass.h"

#include <cstddef>

namespace throng::render {
namespace {

constexpr GLuint line_binding = 0;
constexpr GLint picture_location = 0, opacity_location = 1;
constexpr float seen_opacity = 0.85F, hidden_opacity = 0.16F;
constexpr GLsizei corners_of_a_ribbon = 6;

enum Attribute : GLuint { from_attribute, to_attribute, color_attribute };

gl::VertexArray create_layout() {
  gl::VertexArray array = gl::create_vertex_array();
  const GLuint id = array.id();
  glVertexArrayAttribFormat(id, from_attribute, 3, GL_FLOAT, GL_FALSE, offsetof(SceneLine, from));
  glVertexArrayAttribFormat(id, to_attribute, 3, GL_FLOAT, GL_FALSE, offsetof(SceneLine, to));
  glVertexArrayAttribFormat(id, color_attribute, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(SceneLine, color));
  for (const GLuint attribute : {from_attribute, to_attribute, color_attribute}) {
    glEnableVertexArrayAttrib(id, attribute);
    glVertexArrayAttribBinding(id, attribute, line_binding);
  }
  glVertexArrayBindingDivisor(id, line_binding, 1);
  return array;
}

}  // namespace

Result<LinePass> LinePass::create(ShaderLibrary& shaders) {
  const Result<ProgramHandle> program = shaders.load({"line.vert", "line.frag", {}});
  if (!program) return program.error();
  return LinePass(shaders, *program);
}

LinePass::LinePass(const ShaderLibrary& shaders, ProgramHandle program)
    : shaders_(&shaders), program_(program), vertex_array_(create_layout()), lines_(gl::create_buffer()) {
  glVertexArrayVertexBuffer(vertex_array_.id(), line_binding, lines_.id(), 0, sizeof(SceneLine));
}

DrawCounts LinePass::draw(std::span<const SceneLine> lines, glm::ivec2 picture) {
  if (lines.empty()) return {};
  glNamedBufferData(lines_.id(), static_cast<GLsizeiptr>(lines.size_bytes()), lines.data(), GL_STREAM_DRAW);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glUseProgram(shaders_->id(program_));
  glUniform2f(picture_location, static_cast<float>(picture.x), static_cast<float>(picture.y));
  glBindVertexArray(vertex_array_.id());
  const auto draw_where = [&](GLenum depth, float opacity) {
    glDepthFunc(depth);
    glUniform1f(opacity_location, opacity);
    glDrawArraysInstanced(GL_TRIANGLES, 0, corners_of_a_ribbon, static_cast<GLsizei>(lines.size()));
  };
  draw_where(GL_GEQUAL, seen_opacity);  // depth is reversed
  draw_where(GL_LESS, hidden_opacity);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  return {2, 0};
}

}  // namespace throng::render
