#include "engine/render/passes/line_pass.h"

#include <cstddef>

namespace throng::render {
namespace {

constexpr GLint picture_location = 0, opacity_location = 1;
constexpr float seen_opacity = 0.85F, hidden_opacity = 0.16F;
constexpr GLsizei corners_of_a_ribbon = 6;

constexpr gl::FloatAttribute line_attributes[] = {{3, GL_FLOAT, offsetof(SceneLine, from)},
                                                  {3, GL_FLOAT, offsetof(SceneLine, to)},
                                                  {4, GL_UNSIGNED_BYTE, offsetof(SceneLine, color)}};

}  // namespace

LinePass::LinePass(ShaderLibrary& shaders)
    : program_(shaders.load({"line.vert", "line.frag"})),
      lines_(gl::create_buffer()),
      vertex_array_(gl::create_vertex_array(line_attributes, lines_, sizeof(SceneLine))) {
  glVertexArrayBindingDivisor(vertex_array_.id(), 0, 1);
}

DrawCounts LinePass::draw(std::span<const SceneLine> lines, glm::ivec2 picture, bool show_through) {
  if (lines.empty()) return {};
  glNamedBufferData(lines_.id(), static_cast<GLsizeiptr>(lines.size_bytes()), lines.data(), GL_STREAM_DRAW);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glUseProgram(program_.id());
  glUniform2f(picture_location, static_cast<float>(picture.x), static_cast<float>(picture.y));
  glBindVertexArray(vertex_array_.id());
  const auto draw_where = [&](GLenum depth, float opacity) {
    glDepthFunc(depth);
    glUniform1f(opacity_location, opacity);
    glDrawArraysInstanced(GL_TRIANGLES, 0, corners_of_a_ribbon, static_cast<GLsizei>(lines.size()));
  };
  draw_where(GL_GEQUAL, seen_opacity);  // depth is reversed
  if (show_through) draw_where(GL_LESS, hidden_opacity);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  return {show_through ? 2U : 1U, 0};
}

}  // namespace throng::render
