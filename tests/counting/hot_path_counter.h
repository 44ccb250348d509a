#pragma once

#include <cstdint>

namespace throng {

/// The counts of the whole program so far, on all threads.
struct HotPathCounts {
  std::uint64_t allocations = 0;  ///< calls of operator new
  std::uint64_t locks = 0;        ///< locks of a mutex; not counted under the thread sanitizer, which relies on them

  friend HotPathCounts operator-(const HotPathCounts& a, const HotPathCounts& b) {
    return {a.allocations - b.allocations, a.locks - b.locks};
  }
};
HotPathCounts hot_path_counts();

}  // namespace throng
