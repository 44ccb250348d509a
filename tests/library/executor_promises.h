#pragma once

#include <vector>

#include <gmock/gmock.h>

#include "throng/host.h"

namespace throng::anim {

/// Checks the promises of throng/host.h, frame after frame. Counts are plain integers: the caller sees
/// them only if the executor made the stores of its jobs visible.
inline void expect_each_job_once(Executor& executor, int jobs) {
  for (int frame = 0; frame < 100; ++frame) {
    std::vector<int> runs(static_cast<std::size_t>(jobs), 0);
    executor.run(jobs, {[](void* counts, int index) { ++static_cast<int*>(counts)[index]; }, runs.data()});
    ASSERT_THAT(runs, testing::Each(1)) << "of " << jobs << " jobs in frame " << frame;
  }
}

}  // namespace throng::anim
