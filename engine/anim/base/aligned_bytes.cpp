#include "engine/anim/base/aligned_bytes.h"

#include <cstring>

namespace throng::anim {

AlignedBytes allocate_aligned(std::size_t size) {
  AlignedBytes bytes(new (std::align_val_t{block_alignment}) std::byte[size]);
  std::memset(bytes.get(), 0, size);
  return bytes;
}

}  // namespace throng::anim
