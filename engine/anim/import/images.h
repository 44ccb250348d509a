#pragma once

#include <cstddef>
#include <span>

#include "engine/anim/asset/model.h"

namespace throng::import {

/// The largest side of an image, in pixels.
inline constexpr int max_image_side = 8192;

/// Decodes PNG or JPEG. Throws Refusal.
anim::Image decode_image(std::span<const std::byte> bytes);

}  // namespace throng::import
