#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>

#include "engine/base/run_jobs.h"

namespace throng {

/// Tiles of numbers, shared out over jobs. Each job has a part of its own, the same in each frame, so that its data
/// stay near its core; a job that is done takes tiles of the others.
class SharedTiles {
 public:
  static constexpr std::size_t tile = 128, most_jobs = 64;
  static constexpr std::size_t tiles_worth_a_job = 4;  ///< a PU that gets fewer costs more than it helps

  SharedTiles(std::size_t count, std::size_t jobs) : count_(count), tiles_((count + tile - 1) / tile), jobs_(jobs) {
    for (std::size_t job = 0; job < jobs; ++job) parts_[job].next.store(begin(job), std::memory_order_relaxed);
  }

  template <typename Visit>
  void run(std::size_t job, const Visit& visit) {
    for (std::size_t i = 0; i < jobs_; ++i) {
      const std::size_t part = (job + i) % jobs_, end = begin(part + 1);
      for (std::size_t at = take(part); at < end; at = take(part)) {
        visit(at * tile, std::min((at + 1) * tile, count_));
      }
    }
  }

 private:
  struct alignas(64) Part {
    std::atomic<std::size_t> next{0};
  };
  std::size_t begin(std::size_t part) const { return tiles_ * part / jobs_; }
  std::size_t take(std::size_t part) { return parts_[part].next.fetch_add(1, std::memory_order_relaxed); }

  std::size_t count_, tiles_, jobs_;
  std::array<Part, most_jobs> parts_;
};

/// Calls visit(first, end) for tiles of the numbers below `count`, and shares them out over `jobs` jobs. Two visits
/// must not write the same data, and no visit may read what another writes.
template <typename Visit>
void visit_tiles(std::size_t count, Executor& executor, int jobs, Visit&& visit) {
  if (count == 0) return;
  const std::size_t tiles = (count + SharedTiles::tile - 1) / SharedTiles::tile;
  const std::size_t most = std::min(static_cast<std::size_t>(jobs), SharedTiles::most_jobs);
  const std::size_t used = std::clamp<std::size_t>(tiles / SharedTiles::tiles_worth_a_job, 1, most);
  SharedTiles shared(count, used);
  run_jobs(executor, used, [&](std::size_t job) { shared.run(job, visit); });
}

/// Calls visit(i) for each i below `count`, in the tiles of visit_tiles().
template <typename Visit>
void visit_in_tiles(std::size_t count, Executor& executor, int jobs, Visit&& visit) {
  visit_tiles(count, executor, jobs, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) visit(i);
  });
}

}  // namespace throng
