#include "engine/anim/base/pool.h"

#include <cstring>

#include "engine/anim/base/guard.h"

namespace throng::anim {

Pool::Pool(std::uint32_t id, std::size_t block_size) : id_(id), block_size_(block_size) {
  assert(id < 15 && block_size % 64 == 0 && block_size > 0);
}

void Pool::add_slab() {
  const auto first = static_cast<std::uint32_t>(generations_.size());
  assert(first + blocks_per_slab <= Handle::max_blocks);
  slabs_.push_back(allocate_aligned(blocks_per_slab * block_size_));
  generations_.resize(first + blocks_per_slab, 0);
  alive_.resize(first + blocks_per_slab, false);
  free_.reserve(generations_.size());
  std::vector<std::uint32_t> fresh;
  for (std::uint32_t i = blocks_per_slab; i-- > 0;) fresh.push_back(first + i);
  free_.insert(free_.begin(), fresh.begin(), fresh.end());
}

void Pool::reserve(std::size_t blocks) {
  while (generations_.size() < blocks) add_slab();
}

Handle Pool::create() {
  if (free_.empty()) add_slab();
  const std::uint32_t index = free_.back();
  free_.pop_back();
  alive_[index] = true;
  ++alive_count_;
  std::memset(block_at(index), 0, block_size_);
  return Handle::make(id_, generations_[index], index);
}

void Pool::destroy(Handle handle) {
  assert(alive(handle));
  const std::uint32_t index = handle.index();
  alive_[index] = false;
  generations_[index] = static_cast<std::uint8_t>((generations_[index] + 1) % (1U << Handle::generation_bits));
  --alive_count_;
  free_.push_back(index);
}

bool Pool::alive(Handle handle) const {
  const std::uint32_t index = handle.index();
  return handle.valid() && handle.pool() == id_ && index < alive_.size() && alive_[index] &&
         generations_[index] == handle.generation();
}

void Pool::resize_blocks(std::size_t block_size, const std::function<void(const std::byte*, std::byte*)>& convert) {
  assert(block_size % 64 == 0 && block_size > 0);
  const std::vector<AlignedBytes> old_slabs = std::move(slabs_);
  const std::size_t old_size = block_size_;
  block_size_ = block_size;
  slabs_.clear();
  for (std::size_t i = 0; i < old_slabs.size(); ++i) slabs_.push_back(allocate_aligned(blocks_per_slab * block_size_));
  for (std::uint32_t index = 0; index < alive_.size(); ++index) {
    if (!alive_[index]) continue;
    std::memset(block_at(index), 0, block_size_);
    convert(old_slabs[index / blocks_per_slab].get() + index % blocks_per_slab * old_size, block_at(index));
  }
}

void Pool::guard_blocks() const {
  for (const AlignedBytes& slab : slabs_) guard(slab.get(), blocks_per_slab * block_size_);
}

void Pool::release_blocks() const {
  for (const AlignedBytes& slab : slabs_) release_guard(slab.get(), blocks_per_slab * block_size_);
}

}  // namespace throng::anim
