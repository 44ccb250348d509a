#pragma once

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <span>

#include "engine/anim/base/aligned_bytes.h"

namespace throng::anim {

/// Hands tasks 0, 1, 2, ... to a number of PUs. Each begins with a share of its own, the same tasks frame after frame,
/// so that it finds its data in its caches, and then helps the others. It takes many tasks at once while many
/// are left, and one by one at the end: an atomic operation waits until all that was stored has left the core, which
/// takes long for palettes that are streamed to memory.
class TaskQueue {
  struct Tasks {
    int first = 0;
    int end = 0;
  };

 public:
  static constexpr int most_at_once = 16;

  explicit TaskQueue(int pus) : pus_(pus), shares_(std::make_unique<Share[]>(static_cast<std::size_t>(pus))) {}

  /// Fills the queue before the PUs run. `firsts` has the first task of each share and, last, the number of tasks. PUs
  /// without a share of their own only help.
  void open(std::span<const int> firsts) {
    for (std::size_t pu = 0; pu < static_cast<std::size_t>(pus_); ++pu) {
      const bool has_share = pu + 1 < firsts.size();
      shares_[pu].next.store(has_share ? firsts[pu] : firsts.back(), std::memory_order_relaxed);
      shares_[pu].end = has_share ? firsts[pu + 1] : firsts.back();
    }
  }

  /// The queue as one PU sees it, with the tasks that it has taken and not yet begun.
  class Taker {
   public:
    Taker(TaskQueue& queue, int pu) : queue_(&queue), pu_(pu) {}
    std::optional<int> take() {
      if (taken_.first == taken_.end) taken_ = queue_->take_some(pu_);
      if (taken_.first == taken_.end) return std::nullopt;
      return taken_.first++;
    }

   private:
    TaskQueue* queue_;
    int pu_;
    Tasks taken_;
  };

 private:
  struct alignas(block_alignment) Share {
    std::atomic<int> next{0};
    int end = 0;
  };

  /// Takes no more than half of the tasks that are left for each PU. Returns no tasks if there are no more.
  Tasks take_some(int pu) {
    int of = pu;
    for (int asked = 0; asked < pus_; ++asked, of = of + 1 < pus_ ? of + 1 : 0) {
      Share& share = shares_[static_cast<std::size_t>(of)];
      const int left = share.end - share.next.load(std::memory_order_relaxed);
      if (left <= 0) continue;
      const int count = std::clamp(left / (2 * pus_), 1, most_at_once);
      const int first = share.next.fetch_add(count, std::memory_order_relaxed);
      if (first < share.end) return {first, std::min(first + count, share.end)};
    }
    return {};
  }

  int pus_;
  std::unique_ptr<Share[]> shares_;
};

}  // namespace throng::anim
