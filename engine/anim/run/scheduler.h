#pragma once

#include <memory>
#include <span>
#include <vector>

#include "engine/anim/run/agent_work.h"
#include "engine/anim/run/executor.h"
#include "engine/anim/run/fused_tasks.h"
#include "engine/anim/run/level_tasks.h"
#include "engine/anim/run/processing_unit.h"
#include "engine/anim/run/task_queue.h"

namespace throng::anim {

struct ScheduleOptions {
  Schedule schedule = Schedule::fused;
  DoubleBuffering double_buffering = DoubleBuffering::interleaved;
  LocalStorePlan plan;
  std::size_t local_store_bytes = 0;
  int pus = 1;
};

/// Hands tiles to PUs (paper 2.2.3, 2.2.5, 3.2). Tasks are never equal units: big ones go first, and
/// whoever is free takes the next. The result does not depend on who took what.
class Scheduler {
 public:
  Scheduler(const ScheduleOptions& options, std::size_t palette_entries);

  /// Room for so many agents, so that update() does not allocate.
  void reserve(std::size_t agents);

  /// Poses `agents`, sorted into tiles. The executor runs one job a PU.
  void update(const UpdateContext& context, std::span<const AgentWork> agents, Executor& executor);

  std::span<const ProcessingUnit> units() const { return units_; }
  const ScheduleOptions& options() const { return options_; }

 private:
  std::span<const AgentWork> sorted(std::span<const AgentWork> work);
  void cut_tiles(std::span<const AgentWork> work);
  void collect_entities(std::span<const AgentWork> work);
  void run_fused(const UpdateContext& context, std::span<const AgentWork> work, Executor& executor);
  void run_levels(const UpdateContext& context, std::span<const AgentWork> work, Executor& executor);
  template <typename RunUnit>
  void on_all_units(int task_count, Executor& executor, RunUnit&& run_unit);

  ScheduleOptions options_;
  std::vector<ProcessingUnit> units_;
  std::vector<Tile> tiles_;
  std::vector<AgentWork> sorted_;
  std::vector<std::vector<EntityUpdate>> priorities_;  // [0] players, [i] blenders of priority highest - i
  TaskQueue queue_;
};

}  // namespace throng::anim
