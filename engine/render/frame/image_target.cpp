#include "engine/render/frame/image_target.h"

#include <algorithm>
#include <cassert>
#include <string>

#include <glm/packing.hpp>

#include "engine/render/gl/device_errors.h"

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

/// Gives the first row in memory of a place that is counted from the bottom.
int top_of(const Image& image, const PixelRect& place) { return image.height - place.corner.y - place.size.y; }

}  // namespace

Result<ImageTarget> ImageTarget::create(glm::ivec2 size, int samples) {
  if (Status before = gl::take_errors("what came before a picture"); !before) return before.error();
  ImageTarget target(size, samples);
  if (const Status made = target.check(); !made) return made.error();
  return target;
}

Status ImageTarget::check() const {
  const std::string what = "a picture of " + size_name(size_) + " pixels";
  if (Status made = gl::take_errors(what); !made) return made;
  for (const gl::Framebuffer* framebuffer : {&scene_, &resolved_, &plain_}) {
    if (!*framebuffer) continue;
    if (Status complete = gl::check_complete(framebuffer->id(), what); !complete) return complete;
  }
  return Done{};
}

ImageTarget::ImageTarget(glm::ivec2 size, int samples)
    : size_(size),
      samples_(samples),
      scene_depth_(create_storage(GL_DEPTH_COMPONENT32F, size, samples)),
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
  glNamedFramebufferRenderbuffer(scene_.id(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, scene_depth_.id());
}

void ImageTarget::bind_scene() const {
  glBindFramebuffer(GL_FRAMEBUFFER, scene_.id());
  glViewport(0, 0, size_.x, size_.y);
  glEnable(GL_FRAMEBUFFER_SRGB);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
}

void ImageTarget::clear_scene(const glm::vec3& light) const {
  glDepthMask(GL_TRUE);
  const GLfloat color[4] = {light.r, light.g, light.b, 1.0F};
  glClearNamedFramebufferfv(scene_.id(), GL_COLOR, 0, color);
  constexpr GLfloat farthest = 0.0F;
  glClearNamedFramebufferfv(scene_.id(), GL_DEPTH, 0, &farthest);
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

// Mesa's software drivers ask for the window's size when a viewport is set while the window is the target.
void ImageTarget::copy_to_window(glm::ivec2 window_size) const {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glViewport(0, 0, window_size.x, window_size.y);
  glDisable(GL_FRAMEBUFFER_SRGB);
  const GLenum filter = window_size == size_ ? GL_NEAREST : GL_LINEAR;
  glBlitNamedFramebuffer(plain_.id(), 0, 0, 0, size_.x, size_.y, 0, 0, window_size.x, window_size.y,
                         GL_COLOR_BUFFER_BIT, filter);
}

void ImageTarget::stretch(const ImageTarget& other) const {
  glBlitNamedFramebuffer(other.plain_.id(), plain_.id(), 0, 0, other.size_.x, other.size_.y, 0, 0, size_.x, size_.y,
                         GL_COLOR_BUFFER_BIT, GL_LINEAR);
}

void ImageTarget::fill(std::uint32_t color) const {
  const glm::vec4 srgb = glm::unpackUnorm4x8(color);
  glClearNamedFramebufferfv(plain_.id(), GL_COLOR, 0, &srgb.x);
}

void ImageTarget::copy_pixels(const gl::Texture& texture) const {
  glCopyImageSubData(plain_view_.id(), GL_TEXTURE_2D, 0, 0, 0, 0, texture.id(), GL_TEXTURE_2D, 0, 0, 0, 0, size_.x,
                     size_.y, 1);
}

void ImageTarget::read(Image& image, const PixelRect& place) const {
  const int top = top_of(image, place);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, plain_.id());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ROW_LENGTH, image.width);
  glReadPixels(0, 0, place.size.x, place.size.y, GL_RGBA, GL_UNSIGNED_BYTE, image.pixel(place.corner.x, top));
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  const std::size_t row = static_cast<std::size_t>(place.size.x) * 4;
  const auto row_at = [&](int y) { return image.pixel(place.corner.x, top + y); };
  for (int y = 0; y < place.size.y / 2; ++y) {
    std::swap_ranges(row_at(y), row_at(y) + row, row_at(place.size.y - 1 - y));
  }
  for (int y = 0; y < place.size.y; ++y) {
    for (std::size_t alpha = 3; alpha < row; alpha += 4) row_at(y)[alpha] = 255;
  }
}

void ImageTarget::write(const Image& image, const PixelRect& place) const {
  const int top = top_of(image, place);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (int y = 0; y < place.size.y; ++y) {
    glTextureSubImage2D(plain_view_.id(), 0, 0, place.size.y - 1 - y, place.size.x, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                        image.pixel(place.corner.x, top + y));
  }
}

}  // namespace throng::render
