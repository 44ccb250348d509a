#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <span>

#include "engine/anim/base/aligned_bytes.h"

namespace throng::anim {

/// Tasks 0, 1, 2, ... for a number of PUs. Each begins with a share of its own, the same tasks frame after frame, so
/// that it finds in its caches what it left there, and then helps whoever is not done.
class TaskQueue {
 public:
  explicit TaskQueue(int pus) : pus_(pus), shares_(std::make_unique<Share[]>(static_cast<std::size_t>(pus))) {}

  /// Before the PUs run: the first task of each share and, last, how many tasks there are. PUs without a share of their
  /// own only help.
  void open(std::span<const int> firsts) {
    for (std::size_t pu = 0; pu < static_cast<std::size_t>(pus_); ++pu) {
      const bool has_share = pu + 1 < firsts.size();
      shares_[pu].next.store(has_share ? firsts[pu] : firsts.back(), std::memory_order_relaxed);
      shares_[pu].end = has_share ? firsts[pu + 1] : firsts.back();
    }
  }

  std::optional<int> take(int pu) {
    int of = pu;
    for (int asked = 0; asked < pus_; ++asked, of = of + 1 < pus_ ? of + 1 : 0) {
      Share& share = shares_[static_cast<std::size_t>(of)];
      const int task = share.next.fetch_add(1, std::memory_order_relaxed);
      if (task < share.end) return task;
    }
    return std::nullopt;
  }

  /// The queue as one PU sees it.
  class Taker {
   public:
    Taker(TaskQueue& queue, int pu) : queue_(&queue), pu_(pu) {}
    std::optional<int> take() const { return queue_->take(pu_); }

   private:
    TaskQueue* queue_;
    int pu_;
  };

 private:
  struct alignas(block_alignment) Share {
    std::atomic<int> next{0};
    int end = 0;
  };

  int pus_;
  std::unique_ptr<Share[]> shares_;
};

}  // namespace throng::anim
