#pragma once

#include <oneapi/tbb/task_arena.h>

#include "engine/anim/base/executor.h"

namespace throng::anim {

/// The PUs as jobs of oneTBB (target throng::anim_tbb). The arena is the host's: it says how many threads take part,
/// and it outlives this, which outlives every system that was given it. One frame at a time runs in one executor.
///
/// Jobs do not wait for each other, so an arena of fewer threads than PUs is slower and no less right. While it waits,
/// the calling thread takes no other work of the arena: nothing of the host's runs inside an update.
class TbbExecutor final : public Executor {
 public:
  explicit TbbExecutor(tbb::task_arena& arena) : arena_(arena) {}

  void run(int count, Job job) override;

 private:
  tbb::task_arena& arena_;
};

}  // namespace throng::anim
