#include "engine/render/passes/blend_pass.h"

namespace throng::render {
namespace {

constexpr GLuint sums_unit = 0, behind_unit = 1;
constexpr GLsizei corners_of_the_whole = 3;

}  // namespace

void BlendPass::make_storage(const ImageTarget& picture) {
  size_ = picture.size();
  sums_ = gl::create_target_texture(GL_RGBA16F, size_.x, size_.y, picture.samples());
  behind_ = gl::create_target_texture(GL_R16F, size_.x, size_.y, picture.samples());
  target_ = gl::create_framebuffer();
  glNamedFramebufferTexture(target_.id(), GL_COLOR_ATTACHMENT0, sums_.id(), 0);
  glNamedFramebufferTexture(target_.id(), GL_COLOR_ATTACHMENT1, behind_.id(), 0);
  constexpr GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  glNamedFramebufferDrawBuffers(target_.id(), 2, both);
}

void BlendPass::begin(const ImageTarget& picture) {
  if (size_ != picture.size()) make_storage(picture);
  glNamedFramebufferRenderbuffer(target_.id(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, picture.depth().id());
  glBindFramebuffer(GL_FRAMEBUFFER, target_.id());
  constexpr GLfloat none[4] = {0.0F, 0.0F, 0.0F, 0.0F};
  constexpr GLfloat all[4] = {1.0F, 1.0F, 1.0F, 1.0F};
  glClearNamedFramebufferfv(target_.id(), GL_COLOR, 0, none);
  glClearNamedFramebufferfv(target_.id(), GL_COLOR, 1, all);
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
  glBindTextureUnit(sums_unit, sums_.id());
  glBindTextureUnit(behind_unit, behind_.id());
  for (const GLuint unit : {sums_unit, behind_unit}) glBindSampler(unit, 0);
  glBindVertexArray(no_vertices_.id());
  glDrawArrays(GL_TRIANGLES, 0, corners_of_the_whole);
  glDisable(GL_BLEND);
  return {1, 1};
}

}  // namespace throng::render
