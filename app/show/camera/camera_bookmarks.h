#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "app/settings/settings.h"

namespace throng::app {

/// Places of the camera that a person keeps, at the keys 1 to 9.
inline constexpr std::size_t bookmark_count = 9;
using CameraBookmarks = std::array<std::optional<CameraPose>, bookmark_count>;

}  // namespace throng::app
