#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "throng/render/image.h"

#include "engine/base/result.h"
#include "engine/render/frame/picture_tiles.h"
#include "engine/render/gl/handles.h"

namespace throng::render {

/// Receives a drawn picture, and takes it to the window or into an Image.
///
///   multisampled sRGB + depth --resolve()--> sRGB pixels, one sample
///                                                         | the same bytes seen without conversion
///                                                    overlay --> window | Image
class ImageTarget {
 public:
  /// Makes a target. `samples` is 0 or 4. Errors: the device has no memory for it, or cannot draw into it.
  static Result<ImageTarget> create(glm::ivec2 size, int samples);

  glm::ivec2 size() const { return size_; }
  int samples() const { return samples_; }

  /// Binds the scene's framebuffer. Linear colours are converted on write; depth 0 is far.
  void bind_scene() const;

  /// Gives the scene that is bound one colour, linear, and the farthest depth.
  void clear_scene(const glm::vec3& light) const;

  /// Gives the depths of the scene, for a target that shares them.
  const gl::Renderbuffer& depth() const { return scene_depth_; }

  /// Ends the scene by turning its samples into pixels.
  void resolve() const;

  /// Binds the finished pixels, into which sRGB values are written unconverted.
  void bind_overlay() const;

  /// Copies the finished pixels into the window's framebuffer, stretched to `window_size`.
  void copy_to_window(glm::ivec2 window_size) const;

  /// Makes the finished pixels within the scissor rectangle those of another target, stretched smoothly.
  void stretch(const ImageTarget& other) const;
  /// Gives all finished pixels one sRGB colour, red in the lowest byte.
  void fill(std::uint32_t color) const;

  /// Copies the bytes of the finished pixels into an RGBA8 texture of the same size.
  void copy_pixels(const gl::Texture& texture) const;

  /// Copies the first finished pixels to a place in an image of a larger picture. A row of both begins at the left.
  void read(Image& image, const PixelRect& place) const;
  /// Copies the other way: from a place in the image to the first finished pixels.
  void write(const Image& image, const PixelRect& place) const;

 private:
  ImageTarget(glm::ivec2 size, int samples);
  Status check() const;

  glm::ivec2 size_;
  int samples_;
  gl::Renderbuffer scene_color_;  // only with several samples a pixel
  gl::Renderbuffer scene_depth_;
  gl::Texture pixels_;      // sRGB
  gl::Texture plain_view_;  // sees the bytes of pixels_ without conversion
  gl::Framebuffer scene_;
  gl::Framebuffer resolved_;  // only with several samples a pixel
  gl::Framebuffer plain_;
};

}  // namespace throng::render
