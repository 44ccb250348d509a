#pragma once

#include <glm/vec2.hpp>

namespace throng::render {

/// A rectangle of a picture, in pixels from its bottom left.
struct PixelRect {
  glm::ivec2 corner{0};
  glm::ivec2 size{0};

  friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

}  // namespace throng::render
