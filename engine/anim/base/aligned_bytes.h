#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>

namespace throng::anim {

inline constexpr std::size_t block_alignment = 64;

struct AlignedDelete {
  void operator()(std::byte* bytes) const { std::free(bytes); }
};

/// Bytes that own themselves, aligned to a cache line.
using AlignedBytes = std::unique_ptr<std::byte[], AlignedDelete>;

/// `size` zeroed bytes; in huge pages, where they fill half of one and the system has them.
AlignedBytes allocate_aligned(std::size_t size);

/// What lies in these bytes is not needed any more: pages that lie in them whole may go back to the system, although
/// what they were allocated with stays. They are not used again.
void give_back_pages(std::byte* bytes, std::size_t size);

}  // namespace throng::anim
