#include "engine/anim/run/local_store.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/anim/base/guard.h"

namespace throng::anim {
namespace {

constexpr std::size_t line = 64;

// Lines that are on their way at once: enough for them to have arrived when they are moved, few enough not to fill the
// processor's buffers, where everything else would wait behind them.
constexpr std::size_t transfers_under_way = 16;

void begin_transfer(const CopyEngine::Transfer& transfer) {
  if (!transfer.inward) return;  // what goes out is in the local store
  for (std::size_t offset = 0; offset < transfer.size; offset += line) __builtin_prefetch(transfer.from + offset);
}

// Its own loop, never memcpy: the address sanitizer intercepts that, and this must reach guarded pools.
THRONG_COPIES_GUARDED_MEMORY void copy_lines(const std::byte* from, std::byte* to, std::size_t size) {
  using Quarter [[gnu::vector_size(line / 4), gnu::may_alias]] = long long;
  for (std::size_t offset = 0; offset < size; offset += line) {
    const auto* in = reinterpret_cast<const Quarter*>(from + offset);
    auto* out = reinterpret_cast<Quarter*>(to + offset);
    const Quarter first = in[0];
    const Quarter second = in[1];
    const Quarter third = in[2];
    const Quarter fourth = in[3];
    out[0] = first;
    out[1] = second;
    out[2] = third;
    out[3] = fourth;
    asm volatile("" ::: "memory");  // or the compiler would turn the loop back into memcpy
  }
}

}  // namespace

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

void CopyEngine::fetch(const std::byte* main_memory, std::byte* local, std::size_t size) {
  assert(size % line == 0);
  guard(local, size);
  queue_.push_back({main_memory, local, size, true});
  if (queue_.size() <= next_ + transfers_under_way) begin_transfer(queue_.back());
  queued_bytes_ += size;
  queued_counts_.bytes_in += size;
  ++queued_counts_.transfers;
}

void CopyEngine::write_back(const std::byte* local, std::byte* main_memory, std::size_t size) {
  assert(size % line == 0);
  queue_.push_back({local, main_memory, size, false});
  queued_bytes_ += size;
  queued_counts_.bytes_out += size;
  ++queued_counts_.transfers;
}

void CopyEngine::spread_over(int slices, Trace* trace) {
  slices_to_ = trace != nullptr && trace->wants_slices() ? trace : nullptr;
  const std::size_t lines = queued_bytes_ / line;
  const auto parts = static_cast<std::size_t>(std::max(slices, 1));
  slice_bytes_ = (lines + parts - 1) / parts * line;
}

void CopyEngine::advance() {
  if (slices_to_ == nullptr || queued_bytes_ == 0) return move(slice_bytes_);
  const std::uint64_t begin = TraceClock::now();
  move(slice_bytes_);
  slices_to_->add_slice(begin);
}

CopyCounts CopyEngine::finish() {
  move(queued_bytes_);
  queue_.clear();
  next_ = 0;
  slices_to_ = nullptr;
  counts_ += queued_counts_;
  return std::exchange(queued_counts_, {});
}

void CopyEngine::move(std::size_t bytes) {
  std::size_t next = next_;
  std::size_t moved = moved_;
  std::size_t left = bytes;
  while (left > 0 && next < queue_.size()) {
    const Transfer transfer = queue_[next];
    const std::size_t size = std::min(left, transfer.size - moved);
    if (transfer.inward) release_guard(transfer.to + moved, size);
    copy_lines(transfer.from + moved, transfer.to + moved, size);
    left -= size;
    moved += size;
    if (moved < transfer.size) break;
    if (next + transfers_under_way < queue_.size()) begin_transfer(queue_[next + transfers_under_way]);
    ++next;
    moved = 0;
  }
  next_ = next;
  moved_ = moved;
  queued_bytes_ -= bytes - left;
}

CopyCounts CopyEngine::take_counts() { return std::exchange(counts_, {}); }

}  // namespace throng::anim
