#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/anim/base/aligned_bytes.h"

namespace throng::anim {

/// Names a block without an address, so that pools can be compacted, written to disk or put back as they were.
///
///     31..27 pool   26..20 generation   19..0 index
struct Handle {
  static constexpr std::uint32_t index_bits = 20;
  static constexpr std::uint32_t generation_bits = 7;
  static constexpr std::uint32_t max_blocks = 1U << index_bits;
  static constexpr std::uint32_t none = UINT32_MAX;

  std::uint32_t bits = none;

  static constexpr Handle make(std::uint32_t pool, std::uint32_t generation, std::uint32_t index) {
    return {pool << (index_bits + generation_bits) | generation << index_bits | index};
  }
  constexpr std::uint32_t pool() const { return bits >> (index_bits + generation_bits); }
  constexpr std::uint32_t generation() const { return bits >> index_bits & ((1U << generation_bits) - 1); }
  constexpr std::uint32_t index() const { return bits & (max_blocks - 1); }
  constexpr bool valid() const { return bits != none; }
  friend constexpr bool operator==(Handle, Handle) = default;
};
static_assert(sizeof(Handle) == 4);

/// Equal blocks in slabs (paper 2.2.7: "all structures are solid blocks of memory, roughly the same size").
/// Blocks are 64-byte aligned and never move while they live. Used by one thread at a time, at frame boundaries.
class Pool {
 public:
  static constexpr std::uint32_t blocks_per_slab = 1024;

  /// `id` is the pool's number in its handles, 0 to 30; `block_size` a multiple of 64 bytes.
  Pool(std::uint32_t id, std::size_t block_size);

  /// A zeroed block.
  Handle create();
  void destroy(Handle handle);
  bool alive(Handle handle) const;
  std::byte* block(Handle handle) const {
    assert(alive(handle));
    return block_at(handle.index());
  }

  /// Slabs for at least `blocks` blocks, so that no create() up to there allocates.
  void reserve(std::size_t blocks);

  /// Gives every living block `block_size` bytes; `convert(old, new)` fills the zeroed new one. Handles stay valid.
  void resize_blocks(std::size_t block_size, const std::function<void(const std::byte*, std::byte*)>& convert);

  /// Puts every byte of the pool under guard, or takes the guard away (see guard.h).
  void guard_blocks() const;
  void release_blocks() const;

  std::size_t block_size() const { return block_size_; }
  std::size_t alive_count() const { return alive_count_; }
  std::size_t bytes_reserved() const { return slabs_.size() * blocks_per_slab * block_size_; }

 private:
  std::byte* block_at(std::uint32_t index) const {
    return slabs_[index / blocks_per_slab].get() + index % blocks_per_slab * block_size_;
  }
  void add_slab();

  std::uint32_t id_;
  std::size_t block_size_;
  std::vector<AlignedBytes> slabs_;
  std::vector<std::uint8_t> generations_;  // one a block; a handle of an older generation is dead
  std::vector<bool> alive_;
  std::vector<std::uint32_t> free_;  // indices; the last one is handed out next
  std::size_t alive_count_ = 0;
};

}  // namespace throng::anim
