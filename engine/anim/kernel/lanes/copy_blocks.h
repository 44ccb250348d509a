#pragma once

#include <cstddef>
#include <span>

namespace throng::anim {

/// Copies blocks that lie anywhere into a row of blocks, or back. Pointers and sizes are multiples of 64 bytes.
/// Guarded memory may be copied (base/guard.h).
struct CopyBlocksJob {
  std::span<std::byte* const> blocks;  ///< anywhere
  std::byte* local = nullptr;          ///< first block of the row
  std::size_t stride = 0;              ///< bytes from one block of the row to the next
  std::size_t offset = 0;              ///< bytes into each of `blocks`, where the copy begins
  std::size_t size = 0;                ///< bytes copied of each block
  bool inward = true;                  ///< true: into the row
};
bool is_valid(const CopyBlocksJob& job);

}  // namespace throng::anim
