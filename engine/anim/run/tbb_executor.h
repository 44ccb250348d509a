#pragma once

#include <oneapi/tbb/task_arena.h>

#include "throng/host.h"

namespace throng::anim {

/// Runs the PUs as jobs of oneTBB (target throng::anim_tbb), in an arena of the host.
/// The arena decides how many threads take part. An arena of fewer threads than PUs is slower, and the poses are the
/// same, because jobs do not wait for each other.
/// The arena outlives the executor, and the executor outlives every system that uses it.
/// An executor runs one frame at a time.
/// The calling thread takes no other work of the arena while it waits, so no work of the host runs inside an update.
class TbbExecutor final : public Executor {
 public:
  explicit TbbExecutor(tbb::task_arena& arena) : arena_(arena) {}

  void run(int count, Job job) override;

 private:
  tbb::task_arena& arena_;
};

}  // namespace throng::anim
