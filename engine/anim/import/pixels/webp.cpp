#include <cstdint>

#include <webp/decode.h>

#include "engine/anim/import/pixels/decode.h"

namespace throng::import {
namespace {

/// Returns what libwebp holds at most beside the pixels: the pixels of a lossless picture once more, or the alpha of a
/// lossy one, which is packed without loss too; the alpha itself; some rows.
std::uint64_t scratch_size(const WebPBitstreamFeatures& features) {
  constexpr std::uint64_t tables = 1 << 20;
  constexpr int lossy = 1;
  const std::uint64_t pixels = rgba_size(features.width, features.height) / 4;
  const std::uint64_t rows = static_cast<std::uint64_t>(features.width) * 4 * 64;
  return tables + rows + (features.format == lossy && features.has_alpha == 0 ? 0 : pixels * 5);
}

}  // namespace

Result<anim::Image> decode_webp(std::span<const std::byte> bytes, std::uint64_t budget) {
  const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(data, bytes.size(), &features) != VP8_STATUS_OK) return Error{"its WebP header is broken"};
  int width = features.width, height = features.height;
  if (!sides_fit(width, height)) return sides_do_not_fit();
  const std::uint64_t needed = rgba_size(width, height) + scratch_size(features);
  if (needed > budget) throw OverBudget{needed};
  std::uint8_t* const pixels = WebPDecodeRGBA(data, bytes.size(), &width, &height);
  if (pixels == nullptr) return Error{"its WebP does not decode"};
  return owning_image(width, height, pixels, &WebPFree);
}

}  // namespace throng::import
