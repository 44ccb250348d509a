#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

#include "engine/anim/import/pixels/decode.h"
#include "engine/anim/import/pixels/jpeg_tables.h"

namespace throng::import {
namespace {

/// The memory that stb takes on this thread while it decodes an image.
struct DecoderHeap {
  std::uint64_t budget = 0;
  std::uint64_t held = 0;
  std::uint64_t refused = 0;  ///< the bytes with the refused block; 0: no block was refused
};

thread_local DecoderHeap* decoder_heap = nullptr;  // none: pixels are freed long after their image was decoded

/// Stands before each block. Blocks are as aligned as malloc's.
union alignas(std::max_align_t) BlockHead {
  std::size_t size;
  std::max_align_t align;
};

// The block is zero: stb reads tables that a JPEG does not have, which else would hold another image's.
void* take_block(std::size_t size) {
  if (decoder_heap != nullptr) {
    const std::uint64_t held = decoder_heap->held + size;
    if (held > decoder_heap->budget) {
      decoder_heap->refused = held;
      return nullptr;
    }
  }
  auto* const head = static_cast<BlockHead*>(std::calloc(1, sizeof(BlockHead) + size));
  if (head == nullptr) return nullptr;
  head->size = size;
  if (decoder_heap != nullptr) decoder_heap->held += size;
  return head + 1;
}

void free_block(void* block) {
  if (block == nullptr) return;
  BlockHead* const head = static_cast<BlockHead*>(block) - 1;
  if (decoder_heap != nullptr) decoder_heap->held -= std::min<std::uint64_t>(head->size, decoder_heap->held);
  std::free(head);
}

/// Holds both blocks for a while, as realloc may.
void* grow_block(void* block, std::size_t old_size, std::size_t size) {
  void* const grown = take_block(size);
  if (grown == nullptr || block == nullptr) return grown;
  std::memcpy(grown, block, std::min(old_size, size));
  free_block(block);
  return grown;
}

/// Lets the decoder of this thread take memory from a heap.
class HeapInUse {
 public:
  explicit HeapInUse(DecoderHeap& heap) { decoder_heap = &heap; }
  HeapInUse(const HeapInUse&) = delete;
  HeapInUse& operator=(const HeapInUse&) = delete;
  ~HeapInUse() { decoder_heap = nullptr; }
};

}  // namespace
}  // namespace throng::import

#define STBI_MALLOC(size) throng::import::take_block(size)
#define STBI_REALLOC_SIZED(block, old_size, size) throng::import::grow_block(block, old_size, size)
#define STBI_FREE(block) throng::import::free_block(block)
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"  // of what our macros return
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace throng::import {
namespace {

/// Returns more than stb ever holds for an image of such sides: its rows as they were packed, with 16 bits a channel or
/// as the coefficients of a progressive JPEG, and unpacked, twice.
std::uint64_t most_memory(int width, int height, std::size_t encoded) {
  constexpr std::uint64_t bytes_a_pixel = 24, padding = 64, tables = 1 << 20;
  return (static_cast<std::uint64_t>(width) + padding) * (static_cast<std::uint64_t>(height) + padding) *
             bytes_a_pixel +
         3 * encoded + tables;
}

}  // namespace

Result<anim::Image> decode_png_or_jpeg(std::span<const std::byte> bytes, std::uint64_t budget) {
  if (!jpeg_tables_fit(bytes)) return Error{"a Huffman table of its JPEG has more than 256 codes"};
  const auto* const data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const auto size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  DecoderHeap heap{.budget = std::uint64_t{1} << 24U};
  const HeapInUse in_use(heap);
  if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0) {
    return Error{"it is neither PNG nor JPEG nor WebP"};
  }
  if (!sides_fit(width, height)) return sides_do_not_fit();
  if (rgba_size(width, height) > budget) throw OverBudget{rgba_size(width, height)};
  const std::uint64_t most = most_memory(width, height, bytes.size());
  heap = {.budget = std::min(budget, most)};
  stbi_uc* const pixels = stbi_load_from_memory(data, size, &width, &height, &channels, 4);
  if (pixels != nullptr) return owning_image(width, height, pixels, &stbi_image_free);
  if (heap.refused > most) return Error{"its stream holds more than an image of its size needs"};
  if (heap.refused > 0) throw OverBudget{heap.refused};
  return Error{std::string("it does not decode: ") + stbi_failure_reason()};
}

}  // namespace throng::import
