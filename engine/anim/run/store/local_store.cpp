#include "engine/anim/run/store/local_store.h"

#include <cassert>

#include "engine/anim/base/guard.h"

namespace throng::anim {

LocalStore::LocalStore(std::size_t size) : size_(size), memory_(allocate_aligned(size)) {}

void LocalStore::divide(std::size_t fetch_bytes, int fetch_buffers, std::size_t scratch_bytes) {
  release_guard(memory_.get(), size_);
  fetch_bytes_ = fetch_bytes;
  fetch_buffers_ = fetch_buffers;
  scratch_bytes_ = scratch_bytes;
  assert(bytes_used() <= size_);
}

std::span<std::byte> LocalStore::fetch_buffer(int index) const {
  assert(index < fetch_buffers_);
  return {memory_.get() + static_cast<std::size_t>(index) * fetch_bytes_, fetch_bytes_};
}

std::span<std::byte> LocalStore::scratch() const {
  return {memory_.get() + static_cast<std::size_t>(fetch_buffers_) * fetch_bytes_, scratch_bytes_};
}

}  // namespace throng::anim
