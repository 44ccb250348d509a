#include <algorithm>
#include <array>
#include <cstring>

#include "engine/anim/base/pool.h"

namespace throng::anim {

Compaction Pool::compact(std::span<const Handle> order) { return compact_some(SIZE_MAX, order); }

Compaction Pool::compact_some(std::size_t max_blocks, std::span<const Handle> order) {
  assert(max_blocks >= 2 && "an exchange moves two blocks");
  Compaction done{.complete = true};
  const std::uint32_t in_order = put_in_order(order, max_blocks, done);
  if (done.complete) close_holes(in_order, max_blocks, done);
  done.bytes_given_back = give_back_empty_slabs();
  return done;
}

// Returns the first place behind the places that `order` fills.
std::uint32_t Pool::put_in_order(std::span<const Handle> order, std::size_t max_blocks, Compaction& done) {
  std::uint32_t next = 0;
  for (const Handle handle : order) {
    if (!alive(handle)) continue;
    const std::uint32_t place = tables_.place_of(handle.index());
    if (place < next) continue;  // a repetition: everything before `next` is in place
    if (place != next) {
      const bool into_hole = tables_.owner_of(next) == PoolTables::none;
      const std::size_t moves = into_hole ? 1 : 2;
      done.complete = moves <= max_blocks - done.blocks_moved;
      if (!done.complete) return next;
      if (into_hole) {
        std::memcpy(block_at(next), block_at(place), block_size_);
        tables_.move(place, next);
      } else {
        exchange_blocks(place, next);
      }
      done.blocks_moved += moves;
    }
    ++next;
  }
  return next;
}

void Pool::close_holes(std::uint32_t first, std::size_t max_blocks, Compaction& done) {
  const std::uint32_t end = tables_.place_count();
  std::uint32_t hole = tables_.first_hole(first);
  std::uint32_t place = tables_.first_owned(hole);
  while (place < end && done.blocks_moved < max_blocks) {
    std::memcpy(block_at(hole), block_at(place), block_size_);
    tables_.move(place, hole);
    ++done.blocks_moved;
    hole = tables_.first_hole(hole + 1);
    place = tables_.first_owned(place + 1);
  }
  done.complete = place >= end;
}

std::size_t Pool::give_back_empty_slabs() {
  std::size_t used = slabs_.size();
  while (used > 0 && tables_.alive_in_slab(used - 1) == 0) --used;
  const std::size_t kept = std::max(used + 1, slabs_of(reserved_blocks_));
  const std::size_t before = bytes_reserved();
  while (slabs_.size() > kept) give_slab_back();
  return before - bytes_reserved();
}

void Pool::exchange_blocks(std::uint32_t one, std::uint32_t other) {
  using Line = std::array<std::byte, block_alignment>;
  std::byte* const first = block_at(one);
  std::byte* const second = block_at(other);
  for (std::size_t at = 0; at < block_size_; at += sizeof(Line)) {
    Line line;
    std::memcpy(line.data(), first + at, sizeof(Line));
    std::memcpy(first + at, second + at, sizeof(Line));
    std::memcpy(second + at, line.data(), sizeof(Line));
  }
  tables_.exchange(one, other);
}

}  // namespace throng::anim
