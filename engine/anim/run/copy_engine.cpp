#include "engine/anim/run/copy_engine.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace throng::anim {

void CopyEngine::push(const Entry& entry) {
  assert(entry.row.size % block_alignment == 0 && entry.row.stride % block_alignment == 0);
  const std::size_t count = entry.blocks().size();
  for (std::size_t i = 0; entry.inward && i < count; ++i) guard(entry.local(i), entry.row.size);
  (entry.inward ? queued_.bytes_in : queued_.bytes_out) += count * entry.moved_size();
  queued_.transfers += count;
  queue_.push_back(entry);
}

void CopyEngine::spread_over(int slices, Trace* trace) {
  slices_to_ = trace != nullptr && trace->wants_slices() ? trace : nullptr;
  const std::size_t bytes = queued_.bytes_in + queued_.bytes_out - moved_bytes_;
  const auto parts = static_cast<std::size_t>(std::max(slices, 1));
  slice_bytes_ = (bytes + parts - 1) / parts;
  due_bytes_ = moved_bytes_;
}

void CopyEngine::advance() {
  due_bytes_ += slice_bytes_;
  if (slices_to_ == nullptr || entry_ == queue_.size()) return move(due_bytes_);
  const std::uint64_t begin = TraceClock::now();
  move(due_bytes_);
  slices_to_->add_slice(begin);
}

CopyCounts CopyEngine::finish() {
  move(std::numeric_limits<std::size_t>::max());
  queue_.clear();
  entry_ = moved_bytes_ = due_bytes_ = slice_bytes_ = 0;
  slices_to_ = nullptr;
  counts_ += queued_;
  return std::exchange(queued_, {});
}

void CopyEngine::move(std::size_t due) {
  while (entry_ < queue_.size() && moved_bytes_ < due) {
    const Entry& entry = queue_[entry_];
    const std::size_t size = entry.moved_size();
    const std::size_t left = entry.blocks().size() - moved_blocks_;
    const std::size_t wanted = due - moved_bytes_;
    const std::size_t count = left * size <= wanted ? left : (wanted + size - 1) / size;
    move_blocks(entry, moved_blocks_, moved_blocks_ + count);
    moved_bytes_ += count * size;
    moved_blocks_ += count;
    if (count < left) return;
    ++entry_;
    moved_blocks_ = 0;
  }
}

void CopyEngine::move_blocks(const Entry& entry, std::size_t first, std::size_t end) const {
  for (std::size_t i = first; entry.inward && i < end; ++i)
    release_guard(entry.local(i) + entry.skipped, entry.moved_size());
  CopyBlocksJob job{.blocks = entry.blocks().subspan(first, end - first),
                    .local = entry.local(first) + entry.skipped,
                    .stride = entry.row.stride,
                    .offset = entry.skipped,
                    .size = entry.moved_size(),
                    .inward = entry.inward};
  if (entry_ + 1 < queue_.size() && queue_[entry_ + 1].inward) {
    const std::span<std::byte* const> next = queue_[entry_ + 1].blocks();
    const std::size_t next_end = end == entry.blocks().size() ? next.size() : std::min(end, next.size());
    job.soon = next.subspan(std::min(first, next_end), next_end - std::min(first, next_end));
    job.soon_offset = queue_[entry_ + 1].skipped;
    job.soon_size = queue_[entry_ + 1].moved_size();
  }
  kernels_->copy_blocks(job);
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
