#pragma once

#include <cstddef>
#include <memory>

#include "throng/host.h"

namespace throng::anim {

inline constexpr std::size_t block_alignment = 64;
inline constexpr std::size_t huge_page_bytes = std::size_t{2} << 20U;

/// Gives bytes back to their giver (throng/host.h), unless they were lent.
struct AlignedDelete {
  bool lent = false;  ///< the bytes belong to another owner, who keeps them for longer
  std::size_t size = 0;
  std::size_t alignment = block_alignment;
  MemoryHooks giver{};  ///< without functions: operator new gave them
  void operator()(std::byte* bytes) const;
};

/// Owns bytes that are aligned to a cache line, or holds lent ones.
using AlignedBytes = std::unique_ptr<std::byte[], AlignedDelete>;

/// Allocates `size` zeroed bytes, in huge pages where they fill half of one and the system has them.
AlignedBytes allocate_aligned(std::size_t size);
/// Allocates bytes as allocate_aligned() does, but does not set them. Pages that are not written take no memory.
AlignedBytes allocate_unset(std::size_t size);

/// Holds aligned bytes that belong to another owner, who keeps them for longer. They are not written.
inline AlignedBytes lend_aligned(const std::byte* bytes) {
  return {const_cast<std::byte*>(bytes), AlignedDelete{.lent = true}};
}

/// Asks for huge pages for bytes that begin where one may. It is a hint: systems without them do nothing.
void ask_for_huge_pages(std::byte* bytes, std::size_t size);

}  // namespace throng::anim
