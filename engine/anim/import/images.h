#pragma once

#include <string>

#include "engine/anim/asset/model.h"
#include "engine/anim/import/document.h"

namespace throng::import {

/// Returns an image of the file, decoded, and adds to Document::repairs how its uri was understood. Images that lie in
/// the same file or in the same bytes are decoded once, and share their pixels. Throws Refusal.
anim::Image read_image(Document& document, int image);

/// Returns `image 3 "skin.png"`, for messages.
std::string image_label(const Document& document, int image);

}  // namespace throng::import
