#include "engine/render/frame/blend_target.h"

namespace throng::render {

void BlendTarget::make_storage(const ImageTarget& picture) {
  size_ = picture.size();
  sums_ = gl::create_target_texture(GL_RGBA16F, size_.x, size_.y, picture.samples());
  behind_ = gl::create_target_texture(GL_R16F, size_.x, size_.y, picture.samples());
  framebuffer_ = gl::create_framebuffer();
  glNamedFramebufferTexture(framebuffer_.id(), GL_COLOR_ATTACHMENT0, sums_.id(), 0);
  glNamedFramebufferTexture(framebuffer_.id(), GL_COLOR_ATTACHMENT1, behind_.id(), 0);
  constexpr GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  glNamedFramebufferDrawBuffers(framebuffer_.id(), 2, both);
}

void BlendTarget::bind(const ImageTarget& picture) {
  if (size_ != picture.size()) make_storage(picture);
  glNamedFramebufferRenderbuffer(framebuffer_.id(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, picture.depth().id());
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  constexpr GLfloat none[4] = {0.0F, 0.0F, 0.0F, 0.0F};
  constexpr GLfloat all[4] = {1.0F, 1.0F, 1.0F, 1.0F};
  glClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, 0, none);
  glClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, 1, all);
}

}  // namespace throng::render
