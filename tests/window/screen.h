#pragma once

#include <optional>
#include <string>

#include <glm/vec2.hpp>

#include "throng/render/image.h"

namespace throng::app {

/// Returns what a display shows, from its top left corner on; nothing if it cannot be read or is smaller.
std::optional<render::Image> picture_of_screen(const std::string& display, glm::ivec2 size);

}  // namespace throng::app
