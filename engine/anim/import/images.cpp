#include "engine/anim/import/images.h"

#include <memory>
#include <string>

#include "engine/anim/import/refusal.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#include <stb/stb_image.h>

namespace throng::import {

anim::Image decode_image(std::span<const std::byte> bytes) {
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const auto size = static_cast<int>(bytes.size());
  anim::Image image;
  int channels = 0;
  if (stbi_info_from_memory(data, size, &image.width, &image.height, &channels) == 0) {
    throw Refusal("it is neither PNG nor JPEG");
  }
  if (image.width > max_image_side || image.height > max_image_side) {
    throw Refusal("its sides exceed " + std::to_string(max_image_side) + " pixels");
  }
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(data, size, &image.width, &image.height, &channels, 4), &stbi_image_free);
  if (pixels == nullptr) throw Refusal(std::string("it does not decode: ") + stbi_failure_reason());
  const std::size_t pixel_count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  image.rgba.assign(pixels.get(), pixels.get() + pixel_count * 4);
  return image;
}

}  // namespace throng::import
