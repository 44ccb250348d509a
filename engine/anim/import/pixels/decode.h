#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/anim/asset/model.h"
#include "engine/base/result.h"

namespace throng::import {

/// Says how many bytes a decoder would have to hold at a time, which are more than it may.
struct OverBudget {
  std::uint64_t bytes = 0;
};

/// Decodes an image by the format of its bytes, PNG, JPEG or WebP, whatever its name says. The decoder holds no more
/// than `budget` bytes at a time, the pixels among them, and no more than an image of such sides needs. The error is a
/// part of a sentence: "its WebP does not decode". Throws OverBudget.
Result<anim::Image> decode_image(std::span<const std::byte> bytes, std::uint64_t budget);

// decode_image() calls one of these.
Result<anim::Image> decode_png_or_jpeg(std::span<const std::byte> bytes, std::uint64_t budget);
Result<anim::Image> decode_webp(std::span<const std::byte> bytes, std::uint64_t budget);

// Helpers of both.
inline constexpr int max_image_side = 8192;  // pixels

inline bool sides_fit(int width, int height) { return width <= max_image_side && height <= max_image_side; }
Error sides_do_not_fit();

inline std::uint64_t rgba_size(int width, int height) {
  return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) * 4;
}

/// Makes an image of the pixels that a decoder allocated.
anim::Image owning_image(int width, int height, std::uint8_t* rgba, void (*free_pixels)(void*));

}  // namespace throng::import
