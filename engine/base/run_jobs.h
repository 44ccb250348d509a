#pragma once

#include <algorithm>
#include <cstddef>

#include "throng/host.h"

namespace throng {

/// Calls visit(index) for each index below `count`, once each, as jobs of an executor. Allocates nothing.
template <typename Visit>
void run_jobs(Executor& executor, std::size_t count, Visit visit) {
  executor.run(
      static_cast<int>(count),
      {[](void* context, int index) { (*static_cast<Visit*>(context))(static_cast<std::size_t>(index)); }, &visit});
}

/// Calls visit(first, end) for ranges of the numbers below `count`, as up to `jobs` jobs of `least` numbers or more.
/// Allocates nothing.
template <typename Visit>
void run_ranges(Executor& executor, std::size_t count, std::size_t least, int jobs, Visit visit) {
  const std::size_t ranges = std::clamp<std::size_t>(count / least, 1, static_cast<std::size_t>(jobs));
  run_jobs(executor, ranges, [&](std::size_t range) { visit(count * range / ranges, count * (range + 1) / ranges); });
}

}  // namespace throng
