#include "engine/render/passes/ground_pass.h"

namespace throng::render {
namespace {

constexpr GLint sun_side_location = 0;
constexpr GLsizei corners_of_a_disc = 4;

}  // namespace

GroundPass::GroundPass(ShaderLibrary& shaders)
    : ground_(shaders.load({"ground.vert", "ground.frag"})), spots_(shaders.load({"contact.vert", "contact.frag"})) {}

DrawCounts GroundPass::draw() const {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_EQUAL);  // at the farthest depth, where nothing has been drawn
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glUseProgram(ground_.id());
  glBindVertexArray(no_vertices_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  return {1, 1};
}

DrawCounts GroundPass::draw_spots(std::uint32_t instance_count, bool with_sun_side) const {
  if (instance_count == 0) return {};
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);  // what stands nearer has no spots; depth is reversed
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_SRC_COLOR);
  glUseProgram(spots_.id());
  glUniform1f(sun_side_location, with_sun_side ? 1.0F : 0.0F);
  glBindVertexArray(no_vertices_.id());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, corners_of_a_disc, static_cast<GLsizei>(instance_count));
  glDisable(GL_BLEND);
  return {1, std::uint64_t{2} * instance_count};
}

}  // namespace throng::render
