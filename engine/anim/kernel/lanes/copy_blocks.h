#pragma once

#include <cstddef>
#include <span>

namespace throng::anim {

/// Copies blocks between anywhere and places in a row. Sizes, in bytes, are multiples of 64. Guarded memory may be
/// copied (base/guard.h).
struct CopyBlocksJob {
  std::span<std::byte* const> blocks;  ///< anywhere
  std::byte* local = nullptr;          ///< in a row: the first
  std::size_t stride = 0;              ///< from one to the next in the row
  std::size_t offset = 0;              ///< into each of `blocks`
  std::size_t size = 0;                ///< from there on
  bool inward = true;                  ///< to the row
};

}  // namespace throng::anim
