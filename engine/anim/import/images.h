#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "engine/anim/asset/model.h"
#include "engine/anim/import/document.h"

namespace throng::import {

/// Decodes an image by what its bytes are, PNG, JPEG or WebP, whatever its name says. Throws Refusal.
anim::Image decode_image(std::span<const std::byte> bytes);

/// Reads and decodes an image of the file, and adds to Document::repairs how its uri was understood. Throws Refusal.
anim::Image read_image(Document& document, int image);

/// Returns `image 3 "skin.png"`, for messages.
std::string image_label(const Document& document, int image);

}  // namespace throng::import
