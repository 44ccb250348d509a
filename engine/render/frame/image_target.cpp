#include "engine/render/frame/image_target.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace throng::render {
namespace {

gl::Texture create_plain_view(const gl::Texture& pixels) {
  // glTextureView gives a view its target, so its name must come from glGenTextures, which gives none.
  GLuint view = 0;
  glGenTextures(1, &view);
  glTextureView(view, GL_TEXTURE_2D, pixels.id(), GL_RGBA8, 0, 1, 0, 1);
  return gl::Texture(view);
}

gl::Renderbuffer create_storage(GLenum format, glm::ivec2 size, int samples) {
  gl::Renderbuffer storage = gl::create_renderbuffer();
  glNamedRenderbufferStorageMultisample(storage.id(), samples, format, size.x, size.y);
  return storage;
}

gl::Framebuffer framebuffer_on(const gl::Texture& texture) {
  gl::Framebuffer framebuffer = gl::create_framebuffer();
  glNamedFramebufferTexture(framebuffer.id(), GL_COLOR_ATTACHMENT0, texture.id(), 0);
  return framebuffer;
}

}  // namespace

ImageTarget::ImageTarget(glm::ivec2 size, int samples)
    : size_(size),
      samples_(samples),
      scene_depth_(create_storage(GL_DEPTH32F_STENCIL8, size, samples)),
      pixels_(gl::create_texture(GL_SRGB8_ALPHA8, size.x, size.y)),
      plain_view_(create_plain_view(pixels_)),
      plain_(framebuffer_on(plain_view_)) {
  assert(size.x > 0 && size.y > 0);
  assert(samples == 0 || samples == 4);
  if (samples > 0) {
    scene_color_ = create_storage(GL_SRGB8_ALPHA8, size, samples);
    scene_ = gl::create_framebuffer();
    glNamedFramebufferRenderbuffer(scene_.id(), GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, scene_color_.id());
    resolved_ = framebuffer_on(pixels_);
  } else {
    scene_ = framebuffer_on(pixels_);
  }
  glNamedFramebufferRenderbuffer(scene_.id(), GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, scene_depth_.id());
  assert(glCheckNamedFramebufferStatus(scene_.id(), GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
  assert(glCheckNamedFramebufferStatus(plain_.id(), GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
}

void ImageTarget::bind_scene() const {
  glBindFramebuffer(GL_FRAMEBUFFER, scene_.id());
  glViewport(0, 0, size_.x, size_.y);
  glEnable(GL_FRAMEBUFFER_SRGB);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
}

void ImageTarget::clear_scene() const {
  glDepthMask(GL_TRUE);
  glStencilMask(0xFF);
  constexpr GLfloat black[4] = {0.0F, 0.0F, 0.0F, 1.0F};
  glClearNamedFramebufferfv(scene_.id(), GL_COLOR, 0, black);
  glClearNamedFramebufferfi(scene_.id(), GL_DEPTH_STENCIL, 0, 0.0F, 0);
}

void ImageTarget::resolve() const {
  if (samples_ == 0) return;
  glBlitNamedFramebuffer(scene_.id(), resolved_.id(), 0, 0, size_.x, size_.y, 0, 0, size_.x, size_.y,
                         GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void ImageTarget::bind_overlay() const {
  glBindFramebuffer(GL_FRAMEBUFFER, plain_.id());
  glViewport(0, 0, size_.x, size_.y);
  glDisable(GL_FRAMEBUFFER_SRGB);
}

void ImageTarget::copy_to_window(glm::ivec2 window_size) const {
  glDisable(GL_FRAMEBUFFER_SRGB);
  const GLenum filter = window_size == size_ ? GL_NEAREST : GL_LINEAR;
  glBlitNamedFramebuffer(plain_.id(), 0, 0, 0, size_.x, size_.y, 0, 0, window_size.x, window_size.y,
                         GL_COLOR_BUFFER_BIT, filter);
}

void ImageTarget::copy_pixels(const gl::Texture& texture) const {
  glCopyImageSubData(plain_view_.id(), GL_TEXTURE_2D, 0, 0, 0, 0, texture.id(), GL_TEXTURE_2D, 0, 0, 0, 0, size_.x,
                     size_.y, 1);
}

Image ImageTarget::read() const {
  Image image = Image::blank(size_.x, size_.y);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, plain_.id());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  const std::size_t row = static_cast<std::size_t>(size_.x) * 4;
  for (int y = 0; y < size_.y / 2; ++y) {
    std::swap_ranges(image.pixel(0, y), image.pixel(0, y) + row, image.pixel(0, size_.y - 1 - y));
  }
  for (std::size_t alpha = 3; alpha < image.rgba.size(); alpha += 4) image.rgba[alpha] = 255;
  return image;
}

}  // namespace throng::render
