#pragma once

#include <glm/vec2.hpp>

#include "engine/render/frame/image_target.h"

namespace throng::render {

/// Sums up surfaces that are seen through, over the depths of a picture. Nearer opaque surfaces hide them.
///
///   sums    RGBA16F   colours and alphas, added up
///   behind  R16F      share of the picture that stays, multiplied
class BlendTarget {
 public:
  /// Binds the sums as colours 0 and 1, empty. Makes storage of the picture's size and samples at the first call.
  /// If the device has none left, drawing is an error of OpenGL, which the renderer asks for once a frame.
  void bind(const ImageTarget& picture);

  const gl::Texture& sums() const { return sums_; }
  const gl::Texture& behind() const { return behind_; }

 private:
  void make_storage(const ImageTarget& picture);

  glm::ivec2 size_{0};
  gl::Texture sums_;
  gl::Texture behind_;
  gl::Framebuffer framebuffer_;
};

}  // namespace throng::render
