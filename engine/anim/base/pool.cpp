#include "engine/anim/base/pool.h"

#include <cstring>
#include <utility>

#include "engine/anim/base/guard.h"

namespace throng::anim {

Pool::Pool(std::uint32_t id, std::size_t block_size, std::uint32_t max_blocks)
    : id_(id), block_size_(block_size), tables_(max_blocks) {
  assert(id < 31 && block_size % 64 == 0 && block_size > 0 && max_blocks <= Handle::max_blocks);
}

void Pool::grow_to(std::size_t slabs) {
  if (slabs <= slabs_.size()) return;
  const std::size_t count = slabs - slabs_.size();
  memory_.push_back(allocate_unset(count * slab_bytes()));  // blocks that no agent has had take no memory
  for (std::size_t i = 0; i < count; ++i) slabs_.push_back(memory_.back().get() + i * slab_bytes());
  while (tables_.slab_count() < slabs_.size()) tables_.add_slab();
}

Handle Pool::create() {
  if (room() == 0) return {};
  if (tables_.alive_count() == tables_.place_count()) grow_to(slabs_.size() + 1);
  const std::uint32_t index = tables_.bind();
  std::memset(block_at(tables_.place_of(index)), 0, block_size_);
  return Handle::make(id_, tables_.generation_of(index), index);
}

void Pool::destroy(Handle handle) {
  assert(alive(handle));
  tables_.unbind(handle.index());
}

bool Pool::alive(Handle handle) const {
  return handle.valid() && handle.pool() == id_ && tables_.alive(handle.index(), handle.generation());
}

void Pool::resize_blocks(std::size_t block_size, const std::function<void(const std::byte*, std::byte*)>& convert) {
  assert(block_size % 64 == 0 && block_size > 0);
  const std::vector<std::byte*> old_slabs = std::exchange(slabs_, {});
  const std::vector<AlignedBytes> old_memory = std::exchange(memory_, {});
  const std::size_t old_size = std::exchange(block_size_, block_size);
  grow_to(old_slabs.size());
  for (std::uint32_t place = tables_.first_owned(0); place < tables_.place_count();
       place = tables_.first_owned(place + 1)) {
    std::memset(block_at(place), 0, block_size_);
    convert(old_slabs[place / blocks_per_slab] + place % blocks_per_slab * old_size, block_at(place));
  }
}

void Pool::guard_blocks() const {
  for (const std::byte* slab : slabs_) guard(slab, slab_bytes());
}

void Pool::release_blocks() const {
  for (const std::byte* slab : slabs_) release_guard(slab, slab_bytes());
}

PoolMemory Pool::memory() const {
  return {.blocks_alive = alive_count(),
          .blocks_capacity = tables_.place_count(),
          .bytes_alive = alive_count() * block_size_,
          .bytes_reserved = bytes_reserved(),
          .bytes_of_tables = tables_.bytes()};
}

}  // namespace throng::anim
