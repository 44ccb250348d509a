#include "engine/anim/import/images.h"

#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>

#include <webp/decode.h>

#include "engine/anim/import/refusal.h"
#include "engine/anim/import/source_file.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#include <stb/stb_image.h>

namespace throng::import {

namespace {

constexpr int max_image_side = 8192;  // pixels
constexpr std::string_view ktx2_magic = "\xABKTX 20\xBB";

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

const std::uint8_t* unsigned_bytes(std::span<const std::byte> bytes) {
  return reinterpret_cast<const std::uint8_t*>(bytes.data());
}

bool is_webp(std::string_view text) { return text.starts_with("RIFF") && text.substr(0, 12).ends_with("WEBP"); }

/// Throws Refusal.
void check_sides(int width, int height) {
  if (width <= max_image_side && height <= max_image_side) return;
  throw Refusal("its sides exceed " + std::to_string(max_image_side) + " pixels");
}

/// Makes an image of the pixels that a decoder allocated.
anim::Image owning_image(int width, int height, std::uint8_t* rgba, void (*free_pixels)(void*)) {
  const std::size_t bytes = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4;
  return {.width = width,
          .height = height,
          .rgba = {rgba, bytes},
          .lender = std::shared_ptr<const void>(static_cast<void*>(rgba), free_pixels)};
}

anim::Image decode_webp(std::span<const std::byte> bytes) {
  int width = 0;
  int height = 0;
  if (WebPGetInfo(unsigned_bytes(bytes), bytes.size(), &width, &height) == 0)
    throw Refusal("its WebP header is broken");
  check_sides(width, height);
  std::uint8_t* const pixels = WebPDecodeRGBA(unsigned_bytes(bytes), bytes.size(), &width, &height);
  if (pixels == nullptr) throw Refusal("its WebP does not decode");
  return owning_image(width, height, pixels, &WebPFree);
}

anim::Image decode_png_or_jpeg(std::span<const std::byte> bytes) {
  const stbi_uc* data = unsigned_bytes(bytes);
  const auto size = static_cast<int>(bytes.size());
  int width = 0;
  int height = 0;
  int channels = 0;
  if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0) {
    throw Refusal("it is neither PNG nor JPEG nor WebP");
  }
  check_sides(width, height);
  stbi_uc* const pixels = stbi_load_from_memory(data, size, &width, &height, &channels, 4);
  if (pixels == nullptr) throw Refusal(std::string("it does not decode: ") + stbi_failure_reason());
  return owning_image(width, height, pixels, &stbi_image_free);
}

std::vector<std::byte> read_image_bytes(Document& document, int image) {
  const ImageSource& source = document.images[static_cast<std::size_t>(image)];
  if (source.buffer_view >= 0) {
    const auto bytes = document.buffer_views.views[static_cast<std::size_t>(source.buffer_view)];
    return {bytes.begin(), bytes.end()};
  }
  return document.files.read(source.uri, image_label(document, image), document.repairs);
}

}  // namespace

anim::Image decode_image(std::span<const std::byte> bytes) {
  const std::string_view text = text_of(bytes);
  if (text.starts_with(ktx2_magic)) throw Refusal("it is KTX2, which is not decoded; add a PNG or JPEG to its texture");
  return is_webp(text) ? decode_webp(bytes) : decode_png_or_jpeg(bytes);
}

anim::Image read_image(Document& document, int image) { return decode_image(read_image_bytes(document, image)); }

std::string image_label(const Document& document, int image) {
  constexpr std::size_t longest = 200;  // characters; a data URI holds the whole image
  const std::string& uri = document.images[static_cast<std::size_t>(image)].uri;
  return label("image", static_cast<std::size_t>(image), uri.size() > longest ? std::string() : uri);
}

}  // namespace throng::import
