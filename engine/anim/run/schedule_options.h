#pragma once

#include <cstddef>

#include "engine/anim/kernel/palette/write_lines.h"
#include "engine/anim/run/program/cost_model.h"
#include "engine/anim/run/store/local_store.h"
#include "engine/anim/run/store/schedule.h"

namespace throng::anim {

/// How a Scheduler works. Poses depend on none of it.
struct ScheduleOptions {
  Schedule schedule = Schedule::fused;
  DoubleBuffering double_buffering = DoubleBuffering::interleaved;
  LocalStorePlan plan;
  std::size_t local_store_bytes = 0;
  int pus = 1;
  CostModel cost{};
  StorePolicy stores = StorePolicy::prefetched;
  Tracing trace = Tracing::on;                              ///< the work of each PU is recorded, span by span
  BlockChanges block_changes = BlockChanges::written_back;  ///< only for `fused`; `levels` writes all back
};

}  // namespace throng::anim
