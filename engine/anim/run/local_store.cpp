#include "engine/anim/run/local_store.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace throng::anim {
namespace {

constexpr std::size_t line = 64;

// Lines that are on their way at once: enough for them to have arrived when they are moved, few enough not to fill the
// processor's buffers, where everything else would wait behind them.
constexpr std::size_t transfers_under_way = 16;

void begin(const CopyEngine::Transfer& transfer) {
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
    asm volatile("" : "+r"(offset));  // or the compiler would turn the loop back into memcpy
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

void CopyEngine::spread_over(int slices, Trace* trace) {
  slices_to_ = trace != nullptr && trace->wants_slices() ? trace : nullptr;
  const std::size_t bytes = queued_.bytes_in + queued_.bytes_out - moved_bytes_;
  const auto parts = static_cast<std::size_t>(std::max(slices, 1));
  slice_bytes_ = (bytes + parts - 1) / parts;
  due_bytes_ = moved_bytes_;
  if (moved_ == 0) begin_first();
}

void CopyEngine::advance() {
  due_bytes_ += slice_bytes_;
  if (slices_to_ == nullptr || moved_ == queue_.size()) return move(due_bytes_);
  const std::uint64_t begin = TraceClock::now();
  move(due_bytes_);
  slices_to_->add_slice(begin);
}

CopyCounts CopyEngine::finish() {
  if (moved_ == 0) begin_first();
  move(std::numeric_limits<std::size_t>::max());
  queued_.transfers = queue_.size();
  queue_.clear();
  moved_ = moved_bytes_ = due_bytes_ = slice_bytes_ = 0;
  slices_to_ = nullptr;
  counts_ += queued_;
  return std::exchange(queued_, {});
}

void CopyEngine::begin_first() const {
  for (const Transfer& transfer : std::span(queue_).first(std::min(queue_.size(), transfers_under_way))) {
    begin(transfer);
  }
}

void CopyEngine::move(std::size_t due) {
  const std::span<const Transfer> queue = queue_;
  std::size_t moved = moved_;
  std::size_t moved_bytes = moved_bytes_;
  for (; moved < queue.size() && moved_bytes < due; ++moved) {
    if (moved + transfers_under_way < queue.size()) begin(queue[moved + transfers_under_way]);
    const Transfer& transfer = queue[moved];
    if (transfer.inward) release_guard(transfer.to, transfer.size);
    copy_lines(transfer.from, transfer.to, transfer.size);
    moved_bytes += transfer.size;
  }
  moved_ = moved;
  moved_bytes_ = moved_bytes;
}

CopyCounts CopyEngine::take_counts() { return std::exchange(counts_, {}); }

}  // namespace throng::anim
