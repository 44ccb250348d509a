#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/anim/base/aligned_bytes.h"
#include "engine/anim/base/pool_tables.h"
#include "engine/base/result.h"

namespace throng::anim {

/// Names a block without an address, so that blocks can move, and pools can be put back as they were.
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
static_assert(PoolTables::lives_of_an_index == 1U << Handle::generation_bits);

/// The memory of a pool, in blocks and bytes.
struct PoolMemory {
  std::size_t blocks_alive = 0;
  std::size_t blocks_capacity = 0;  // that the slabs have room for
  std::size_t bytes_alive = 0;      // of living blocks
  std::size_t bytes_reserved = 0;   // of slabs
  std::size_t bytes_of_tables = 0;  // for handles, generations and places, beside the slabs
};

/// A copy of a pool: its tables and the bytes of each slab that had a living block. The caller keeps it and uses it
/// again: it allocates nothing once it has held as many slabs of the same pool.
class PoolSnapshot {
 public:
  std::size_t bytes() const { return slabs_.size() * PoolTables::places_per_slab * block_size_ + tables_.bytes(); }

 private:
  friend class Pool;

  std::uint32_t pool_ = Handle::none;  // no snapshot was taken yet
  std::size_t block_size_ = 0;
  PoolTables tables_;
  std::vector<AlignedBytes> slabs_;  // the slabs that had a living block, in order, and perhaps unused ones
};

/// Equal blocks in slabs (paper 2.2.7: "all structures are solid blocks of memory, roughly the same size").
/// Blocks are 64-byte aligned. They move only in restore() and resize_blocks(): handles outlive a frame boundary,
/// addresses do not. One thread at a time uses a pool, at frame boundaries; any number may call block().
class Pool {
 public:
  static constexpr std::uint32_t blocks_per_slab = PoolTables::places_per_slab;

  /// `id`: the pool's number in its handles, 0 to 30. `block_size`: a multiple of 64 bytes. At most `max_blocks` blocks
  /// live at a time; the fewer, the sooner the bits of a dead handle name a new block (see pool_tables.h).
  Pool(std::uint32_t id, std::size_t block_size, std::uint32_t max_blocks = Handle::max_blocks);

  /// Creates a zeroed block in the lowest free place. The handle is invalid if as many blocks live as can.
  Handle create();
  /// Returns how many more blocks can live.
  std::size_t room() const { return tables_.max_indices() - tables_.alive_count(); }
  void destroy(Handle handle);
  bool alive(Handle handle) const;
  std::byte* block(Handle handle) const {
    assert(alive(handle));
    return block_at(tables_.place_of(handle.index()));
  }

  /// Calls visit(const std::byte* block) for each living block, in the order of their places.
  template <typename Visit>
  void for_each_block(Visit&& visit) const {
    for (std::uint32_t place = tables_.first_owned(0); place < tables_.place_count();
         place = tables_.first_owned(place + 1)) {
      visit(static_cast<const std::byte*>(block_at(place)));
    }
  }

  /// Allocates slabs for at least `blocks` blocks, so that create() allocates none up to there. (Tables grow by some 13
  /// KiB for 262,144 creations, as indices wear out.)
  void reserve(std::size_t blocks) { grow_to((blocks + blocks_per_slab - 1) / blocks_per_slab); }

  /// Gives every living block `block_size` bytes; `convert(old, new)` fills the zeroed new one. Handles stay valid.
  void resize_blocks(std::size_t block_size, const std::function<void(const std::byte*, std::byte*)>& convert);

  /// Copies the pool into `into`.
  void snapshot(PoolSnapshot& into) const;
  /// Rewinds the pool to `from`: handles that were alive are alive again, with the same bytes in the same places, and
  /// all others are dead. Indices and generations are rewound too, so that the same creations give the same handles
  /// again. A handle that was made after the snapshot may therefore name another block later, so code that keeps
  /// handles is rewound with the pool. Refused, with nothing changed, if the snapshot is empty, of another pool, or of
  /// blocks of another size. Allocates only if the pool has fewer slabs than it had then.
  Status restore(const PoolSnapshot& from);

  /// Guards every byte of the pool, or takes the guard away (see guard.h).
  void guard_blocks() const;
  void release_blocks() const;

  std::size_t block_size() const { return block_size_; }
  std::size_t alive_count() const { return tables_.alive_count(); }
  std::size_t bytes_reserved() const { return slabs_.size() * slab_bytes(); }
  PoolMemory memory() const;

 private:
  std::size_t slab_bytes() const { return blocks_per_slab * block_size_; }
  std::byte* block_at(std::uint32_t place) const {
    return slabs_[place / blocks_per_slab] + place % blocks_per_slab * block_size_;
  }
  void grow_to(std::size_t slabs);

  std::uint32_t id_;
  std::size_t block_size_;
  PoolTables tables_;
  std::vector<std::byte*> slabs_;
  std::vector<AlignedBytes> memory_;  // owns slabs_; slabs that were made together lie together, in huge pages
};

}  // namespace throng::anim
