#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

#include "engine/anim/base/executor.h"

namespace throng::app {

/// Calls visit(first, end) for tiles of the numbers below `count`, and shares them out over `jobs` jobs. Two visits must
/// not write the same data, and no visit may read what another writes.
template <typename Visit>
void visit_tiles(std::size_t count, anim::Executor& executor, int jobs, Visit&& visit) {
  constexpr std::size_t tile = 128;
  struct Work {
    std::size_t count;
    Visit* visit;
    std::atomic<std::size_t> next_tile{0};
  } work{count, &visit};
  const auto run = [](void* context, int) {
    auto& shared = *static_cast<Work*>(context);
    for (;;) {
      const std::size_t first = tile * shared.next_tile.fetch_add(1, std::memory_order_relaxed);
      if (first >= shared.count) return;
      (*shared.visit)(first, std::min(first + tile, shared.count));
    }
  };
  const auto tiles = static_cast<int>(std::min<std::size_t>((count + tile - 1) / tile, 256));
  if (tiles > 0) executor.run(std::min(jobs, tiles), {run, &work});
}

/// Calls visit(i) for each i below `count`, in such tiles.
template <typename Visit>
void visit_in_tiles(std::size_t count, anim::Executor& executor, int jobs, Visit&& visit) {
  visit_tiles(count, executor, jobs, [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) visit(i);
  });
}

}  // namespace throng::app
