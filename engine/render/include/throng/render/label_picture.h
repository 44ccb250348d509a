#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace throng::render {

/// A rectangle of pixels, counted from the top left; `right` and `bottom` are beyond it.
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;

  int width() const { return right - left; }
  int height() const { return bottom - top; }
  bool is_empty() const { return right <= left || bottom <= top; }
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

/// Says of each pixel which agent is there and how far away, with one sample a pixel; top row first.
struct LabelPicture {
  glm::ivec2 size{0};
  std::vector<std::uint32_t> agents;  ///< InstanceRecord::agent + 1; 0: no agent
  std::vector<float> metres;          ///< along the camera's axis, to crowd, scenery or ground; infinite: to nothing

  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
  }
};

/// Holds the pixels that an instance covers in a picture with nothing else in it.
struct BodyAlone {
  PixelBox box;
  std::uint64_t pixels = 0;
};

}  // namespace throng::render
