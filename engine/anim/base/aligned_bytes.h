#pragma once

#include <cstddef>
#include <memory>
#include <new>

namespace throng::anim {

inline constexpr std::size_t block_alignment = 64;

struct AlignedDelete {
  void operator()(std::byte* bytes) const { ::operator delete[](bytes, std::align_val_t{block_alignment}); }
};

/// Bytes that own themselves, aligned to a cache line.
using AlignedBytes = std::unique_ptr<std::byte[], AlignedDelete>;

/// `size` zeroed bytes.
AlignedBytes allocate_aligned(std::size_t size);

}  // namespace throng::anim
