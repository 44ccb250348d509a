#pragma once

#include <cstddef>

#include "engine/anim/base/executor.h"

namespace throng::anim {

/// Calls visit(index) for each index below `count`, once each, as jobs of an executor. Allocates nothing.
template <typename Visit>
void run_jobs(Executor& executor, std::size_t count, Visit visit) {
  executor.run(
      static_cast<int>(count),
      {[](void* context, int index) { (*static_cast<Visit*>(context))(static_cast<std::size_t>(index)); }, &visit});
}

}  // namespace throng::anim
