#pragma once

#include <glm/vec2.hpp>

#include "engine/render/gl/handles.h"
#include "engine/render/image.h"

namespace throng::render {

/// What is drawn into, and the one way from there to the window or to an Image.
///
///   multisampled sRGB + depth/stencil --resolve()--> sRGB pixels, one sample
///                                                         | the same bytes seen without conversion
///                                                    overlay --> window | Image
class ImageTarget {
 public:
  /// `samples`: 0 or 4.
  ImageTarget(glm::ivec2 size, int samples);

  glm::ivec2 size() const { return size_; }
  int samples() const { return samples_; }

  /// Binds the scene's framebuffer (linear colours are converted on write), cleared, depth reversed: 0 is far.
  void bind_scene() const;

  /// Ends the scene: its samples become pixels.
  void resolve() const;

  /// Binds the finished pixels as they are: sRGB values are written unconverted.
  void bind_overlay() const;

  /// Copies the finished pixels into the window's framebuffer, stretched to `window_size`.
  void copy_to_window(glm::ivec2 window_size) const;

  /// Copies the finished pixels into an RGBA8 texture of the same size, as they are.
  void copy_pixels(const gl::Texture& texture) const;

  Image read() const;

 private:
  glm::ivec2 size_;
  int samples_;
  gl::Renderbuffer scene_color_;  // only where multisampled
  gl::Renderbuffer scene_depth_;
  gl::Texture pixels_;      // sRGB
  gl::Texture plain_view_;  // the bytes of pixels_, read and written unconverted
  gl::Framebuffer scene_;
  gl::Framebuffer resolved_;  // only where multisampled
  gl::Framebuffer plain_;
};

}  // namespace throng::render
