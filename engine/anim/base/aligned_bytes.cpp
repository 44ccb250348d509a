#include "engine/anim/base/aligned_bytes.h"

#include <cstring>
#include <new>

#include "engine/anim/base/misuse.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace throng::anim {
namespace {

// A frame touches thousands of small pages of blocks and palettes, more than the TLB holds.
constexpr std::size_t worth_huge_pages = huge_page_bytes / 2;

std::size_t round_up(std::size_t size, std::size_t unit) { return (size + unit - 1) / unit * unit; }

MemoryHooks hooks_of_the_host{};  // without functions: operator new gives

AlignedBytes given(std::size_t size, std::size_t alignment) {
  const MemoryHooks& giver = hooks_of_the_host;
  void* const bytes = giver.allocate == nullptr ? ::operator new (size, std::align_val_t{alignment})
                                                : giver.allocate(size, alignment, giver.context);
  return {static_cast<std::byte*>(bytes), AlignedDelete{.size = size, .alignment = alignment, .giver = giver}};
}

}  // namespace

void AlignedDelete::operator()(std::byte* bytes) const {
  if (lent) return;
  if (giver.release == nullptr) return ::operator delete (bytes, std::align_val_t{alignment});
  giver.release(bytes, size, alignment, giver.context);
}

AlignedBytes allocate_unset(std::size_t size) {
  const bool huge = size >= worth_huge_pages;
  const std::size_t alignment = huge ? huge_page_bytes : block_alignment;
  const std::size_t allocated = round_up(size, alignment);
  AlignedBytes bytes = given(allocated, alignment);
  if (huge) ask_for_huge_pages(bytes.get(), allocated);
  return bytes;
}

AlignedBytes allocate_aligned(std::size_t size) {
  AlignedBytes bytes = allocate_unset(size);
  if (size > 0) std::memset(bytes.get(), 0, size);
  return bytes;
}

#if defined(__linux__)
// It is a hint, so a refusal does no harm.
void ask_for_huge_pages(std::byte* bytes, std::size_t size) { static_cast<void>(madvise(bytes, size, MADV_HUGEPAGE)); }
#else
void ask_for_huge_pages(std::byte*, std::size_t) {}
#endif

}  // namespace throng::anim

void throng::set_memory_hooks(const MemoryHooks& hooks) {
  if ((hooks.allocate == nullptr) == (hooks.release == nullptr)) {
    anim::hooks_of_the_host = hooks;
  } else {
    anim::report_misuse({"set_memory_hooks", "both functions are given, or neither"});
  }
}
