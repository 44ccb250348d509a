#include "engine/anim/run/store/copy_engine.h"

#include <algorithm>
#include <utility>

#include "engine/base/compiler.h"

namespace throng::anim {
namespace {

/// No more of a block is asked for, because hardware fetches what follows in order.
constexpr std::size_t most_asked_bytes = 256;

}  // namespace

void CopyEngine::write_back_now(const BlockRow& row, std::size_t skipped) {
  const Entry entry{.row = row, .skipped = skipped};
  queued_.bytes_out += entry.moved_bytes();
  queued_.transfers += row.blocks.size();
  move_row(entry);
}

void CopyEngine::spread_over(int slices, Trace* trace) {
  slices_to_ = trace != nullptr && trace->wants_slices() ? trace : nullptr;
  const auto bytes = static_cast<std::uint32_t>(queued_.bytes_in + queued_.bytes_out - moved_bytes_);
  const auto parts = static_cast<std::uint32_t>(std::max(slices, 1));
  slices_left_ = slices;
  slice_bytes_ = (bytes + parts - 1) / parts;  // of 32 bits, which divide in half the time
  due_bytes_ = moved_bytes_;
  ask_for_rows(due_bytes_ + slice_bytes_);
}

void CopyEngine::advance() {
  if (moved_rows_ == queue_.size()) return;
  const std::uint64_t begin = slices_to_ == nullptr ? 0 : TraceClock::now();
  due_bytes_ += slice_bytes_;
  --slices_left_;
  move_rows();
  ask_for_rows(due_bytes_ + slice_bytes_);
  if (slices_to_ != nullptr) slices_to_->add_slice(begin);
}

CopyCounts CopyEngine::finish() {
  slices_left_ = 0;
  move_rows();
  queue_.clear();
  moved_rows_ = moved_bytes_ = asked_rows_ = asked_bytes_ = due_bytes_ = slice_bytes_ = 0;
  slices_to_ = nullptr;
  counts_ += queued_;
  return std::exchange(queued_, {});
}

/// Rows come in with the last slice. If they came sooner, kernels would evict them from L1 again.
bool CopyEngine::is_next_due() const {
  if (moved_rows_ == queue_.size()) return false;
  return slices_left_ <= 0 || (!queue_[moved_rows_].inward && moved_bytes_ < due_bytes_);
}

void CopyEngine::move_rows() {
  while (is_next_due()) {
    const Entry& entry = queue_[moved_rows_++];
    moved_bytes_ += entry.moved_bytes();
    if (slices_left_ <= 0) ask_for_rows(moved_bytes_ + 1);  // the next one
    move_row(entry);
  }
}

/// A hint, for blocks that lie anywhere in main memory.
void CopyEngine::ask_for_rows(std::size_t due) {
  while (asked_rows_ < queue_.size() && asked_bytes_ < due) {
    const Entry& entry = queue_[asked_rows_++];
    asked_bytes_ += entry.moved_bytes();
    if (!entry.inward) continue;
    const std::size_t asked = std::min(entry.moved_size(), most_asked_bytes);
    for (const std::byte* block : entry.blocks()) {
      for (std::size_t offset = 0; offset < asked; offset += block_alignment) prefetch(block + entry.skipped + offset);
    }
  }
}

void CopyEngine::move_row(const Entry& entry) const {
  for (std::size_t i = 0; entry.inward && i < entry.blocks().size(); ++i)
    release_guard(entry.local(i) + entry.skipped, entry.moved_size());
  kernels_->copy_blocks({.blocks = entry.blocks(),
                         .local = entry.row.local + entry.skipped,
                         .stride = entry.row.stride,
                         .offset = entry.skipped,
                         .size = entry.moved_size(),
                         .inward = entry.inward});
}

std::vector<CopyEngine::Transfer> CopyEngine::queued() const {
  std::vector<Transfer> transfers;
  for (const Entry& entry : queue_) {
    for (std::size_t i = 0; i < entry.blocks().size(); ++i) {
      std::byte* const block = entry.blocks()[i] + entry.skipped;
      std::byte* const local = entry.local(i) + entry.skipped;
      transfers.push_back(entry.inward ? Transfer{block, local, entry.moved_size(), true}
                                       : Transfer{local, block, entry.moved_size(), false});
    }
  }
  return transfers;
}

CopyCounts CopyEngine::take_counts() { return std::exchange(counts_, {}); }

}  // namespace throng::anim
