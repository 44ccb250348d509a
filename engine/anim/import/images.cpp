#include "engine/anim/import/images.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/anim/import/bytes/refusal.h"
#include "engine/anim/import/memory/memory_account.h"
#include "engine/anim/import/pixels/decode.h"
#include "engine/anim/import/pixels/halve.h"

namespace throng::import {

namespace {

using Bytes = std::span<const std::byte>;

std::string sides_of(const anim::Image& image) {
  return std::to_string(image.width) + " by " + std::to_string(image.height);
}

/// Scales an image down until it fits into its share of the memory for images, and says so.
void scale_into(std::uint64_t share, anim::Image& image, const std::string& name, std::vector<std::string>& repairs) {
  const std::string before = sides_of(image);
  while (image.rgba.size() > share && image.rgba.size() > 4) image = halved(image);
  if (sides_of(image) == before) return;
  repairs.push_back(name + ": scaled down from " + before + " to " + sides_of(image) +
                    " pixels, because the images of its file would take too much memory; " + larger_limit +
                    " allows more");
}

/// Decodes within the account's limit, and charges the account with the pixels.
Result<anim::Image> decode_within_account(Document& document, Bytes bytes, const std::string& name) {
  MemoryAccount& memory = *document.memory;
  const std::uint64_t budget = memory.decoder_memory();
  const std::size_t known = document.decoded_images.size(), all = document.images.size();
  const std::uint64_t share = memory.image_share(bytes.size(), all > known ? all - known : 1);
  try {
    Result<anim::Image> image = decode_image(bytes, budget);
    if (!image) return image;
    memory.count_decoded(image->rgba.size(), name);
    scale_into(share, *image, name, document.repairs);
    memory.charge_for_image(image->rgba.size(), name);
    return image;
  } catch (const OverBudget& over) {
    memory.refuse(over.bytes, name, budget - memory.left());
  }
}

anim::Image image_of(const Result<anim::Image>& decoded) {
  if (!decoded) throw Refusal(decoded.error().message);
  return *decoded;
}

/// The bytes of an image, and their place, which is equal for images that share them.
struct EncodedImage {
  std::string place;
  std::filesystem::path file;  ///< where they are read; none for a data URI
  Bytes bytes;                 ///< none where they are still in a file or in a uri
};

EncodedImage find_encoded(Document& document, int image, const std::string& name) {
  const ImageSource& source = document.images[static_cast<std::size_t>(image)];
  if (source.buffer_view >= 0) {
    const Bytes bytes = document.buffer_views.views[static_cast<std::size_t>(source.buffer_view)];
    const auto address = reinterpret_cast<std::uintptr_t>(bytes.data());
    return {.place = "at " + std::to_string(address) + " " + std::to_string(bytes.size()), .file = {}, .bytes = bytes};
  }
  const std::filesystem::path file = document.files.find(source.uri, name, document.repairs);
  return {.place = file.empty() ? "image " + std::to_string(image) : file.string(), .file = file, .bytes = {}};
}

}  // namespace

anim::Image read_image(Document& document, int image) {
  const std::string name = image_label(document, image);
  const EncodedImage encoded = find_encoded(document, image, name);
  const auto known = document.decoded_images.find(encoded.place);
  if (known != document.decoded_images.end()) return image_of(known->second);
  std::vector<std::byte> read;
  Bytes bytes = encoded.bytes;
  const MemoryScope scope(*document.memory);
  if (bytes.empty()) {
    const std::string& uri = document.images[static_cast<std::size_t>(image)].uri;
    read = document.files.read(uri, encoded.file, name, *document.memory);
    bytes = read;
  }
  auto decoded = decode_within_account(document, bytes, name);
  return image_of(document.decoded_images.emplace(encoded.place, std::move(decoded)).first->second);
}

std::string image_label(const Document& document, int image) {
  const ImageSource& source = document.images[static_cast<std::size_t>(image)];
  constexpr std::size_t longest = 200;  // characters; a data URI holds the whole image
  const bool is_short = source.uri.size() <= longest;
  return label("image", static_cast<std::size_t>(image), source.name.empty() && is_short ? source.uri : source.name);
}

}  // namespace throng::import
