#pragma once

#include <cstddef>

#include <glm/vec2.hpp>

namespace throng::render::gl {

/// The largest sizes that a device takes, as it says itself.
struct DeviceLimits {
  glm::ivec2 target{0};           ///< pixels of a target: textures, renderbuffers and viewports hold it
  int texture = 0;                ///< pixels of a side
  int samples = 0;                ///< a pixel, of colours and of depths
  std::size_t storage_block = 0;  ///< bytes
};

/// Asks the device of the current context.
DeviceLimits ask_device_limits();

}  // namespace throng::render::gl
