#include "engine/anim/run/tbb_executor.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>

namespace throng::anim {

void TbbExecutor::run(int count, Job job) {
  const auto all_jobs = [count, job] {
    // Static: a PU meets the same thread frame after frame where it can, and with it the caches that hold its share.
    tbb::parallel_for(
        0, count, [job](int index) { job.run(job.context, index); }, tbb::static_partitioner());
  };
  arena_.execute([&all_jobs] { tbb::this_task_arena::isolate(all_jobs); });
}

}  // namespace throng::anim
