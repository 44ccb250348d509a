#include "engine/anim/import/pixels/decode.h"

#include <memory>
#include <string>
#include <string_view>

namespace throng::import {

Error sides_do_not_fit() { return {"its sides exceed " + std::to_string(max_image_side) + " pixels"}; }

anim::Image owning_image(int width, int height, std::uint8_t* rgba, void (*free_pixels)(void*)) {
  return {.width = width,
          .height = height,
          .rgba = {rgba, static_cast<std::size_t>(rgba_size(width, height))},
          .lender = std::shared_ptr<const void>(static_cast<void*>(rgba), free_pixels)};
}

Result<anim::Image> decode_image(std::span<const std::byte> bytes, std::uint64_t budget) {
  constexpr std::string_view ktx2_magic = "\xABKTX 20\xBB";
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with(ktx2_magic)) {
    return Error{"it is KTX2, which is not decoded; add a PNG or JPEG to its texture"};
  }
  const bool is_webp = text.starts_with("RIFF") && text.substr(0, 12).ends_with("WEBP");
  return is_webp ? decode_webp(bytes, budget) : decode_png_or_jpeg(bytes, budget);
}

}  // namespace throng::import
