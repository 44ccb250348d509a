#include "engine/anim/base/aligned_bytes.h"

#include <cstdint>
#include <cstring>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace throng::anim {
namespace {

constexpr std::size_t worth_huge_pages = std::size_t{4} << 20U;

// A crowd's palettes touch thousands of small pages a frame, more than the processor remembers addresses of.
void ask_for_huge_pages(std::byte* bytes, std::size_t size) {
#if defined(__linux__)
  constexpr std::uintptr_t page = 4096;
  const std::uintptr_t first = (reinterpret_cast<std::uintptr_t>(bytes) + page - 1) / page * page;
  const std::uintptr_t end = reinterpret_cast<std::uintptr_t>(bytes + size) / page * page;
  static_cast<void>(madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE));  // a hint: refused is well
#else
  static_cast<void>(bytes);
  static_cast<void>(size);
#endif
}

}  // namespace

AlignedBytes allocate_aligned(std::size_t size) {
  AlignedBytes bytes(new (std::align_val_t{block_alignment}) std::byte[size]);
  if (size >= worth_huge_pages) ask_for_huge_pages(bytes.get(), size);
  std::memset(bytes.get(), 0, size);
  return bytes;
}

}  // namespace throng::anim
