#include "engine/render/passes/blend_pass.h"

namespace throng::render {
namespace {

constexpr GLuint sums_unit = 0, behind_unit = 1;
constexpr GLsizei corners_of_the_whole = 3;

}  // namespace

void BlendPass::begin(const ImageTarget& picture) {
  target_.bind(picture);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunci(sums_unit, GL_ONE, GL_ONE);
  glBlendFunci(behind_unit, GL_ZERO, GL_ONE_MINUS_SRC_COLOR);
}

DrawCounts BlendPass::finish(const ImageTarget& picture) const {
  picture.bind_scene();
  glDepthMask(GL_TRUE);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glBlendFunc(GL_ONE_MINUS_SRC_ALPHA, GL_SRC_ALPHA);
  glUseProgram(picture.samples() > 0 ? average_of_samples_.id() : average_.id());
  glBindTextureUnit(sums_unit, target_.sums().id());
  glBindTextureUnit(behind_unit, target_.behind().id());
  for (const GLuint unit : {sums_unit, behind_unit}) glBindSampler(unit, 0);
  glBindVertexArray(no_vertices_.id());
  glDrawArrays(GL_TRIANGLES, 0, corners_of_the_whole);
  glDisable(GL_BLEND);
  return {1, 1};
}

}  // namespace throng::render
