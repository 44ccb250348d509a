#include "engine/render/passes/split_pass.h"

#include <cassert>

namespace throng::render {
namespace {

constexpr GLuint left_unit = 0, right_unit = 1;
constexpr GLint divider_location = 0, amplification_location = 1;
constexpr GLsizei corners_of_the_picture = 3;

}  // namespace

void SplitPass::keep(Side& side, const ImageTarget& picture) {
  if (side.size != picture.size()) {
    side.size = picture.size();
    side.pixels = gl::create_texture(GL_RGBA8, side.size.x, side.size.y);
  }
  picture.copy_pixels(side.pixels);
}

DrawCounts SplitPass::draw(const ImageTarget& target, const SplitView& split) const {
  assert(left_.size == target.size() && right_.size == target.size());
  target.bind_overlay();
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glUseProgram(program_.id());
  glUniform1f(divider_location, split.divider * static_cast<float>(target.size().x));
  glUniform1f(amplification_location, split.difference ? difference_amplification : 0.0F);
  glBindTextureUnit(left_unit, left_.pixels.id());
  glBindTextureUnit(right_unit, right_.pixels.id());
  glBindVertexArray(no_vertices_.id());
  glDrawArrays(GL_TRIANGLES, 0, corners_of_the_picture);
  return {1, 1};
}

}  // namespace throng::render
