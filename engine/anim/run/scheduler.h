#pragma once

#include <memory>
#include <span>
#include <vector>

#include "engine/anim/base/executor.h"
#include "engine/anim/run/fused/tasks.h"
#include "engine/anim/run/levels/level_tasks.h"
#include "engine/anim/run/processing_unit.h"
#include "engine/anim/run/program/agent_work.h"
#include "engine/anim/run/program/work_order.h"
#include "engine/anim/run/store/task_queue.h"
#include "engine/anim/run/tile_cutter.h"

namespace throng::anim {

struct ScheduleOptions {
  Schedule schedule = Schedule::fused;
  DoubleBuffering double_buffering = DoubleBuffering::interleaved;
  LocalStorePlan plan;
  std::size_t local_store_bytes = 0;
  int pus = 1;
  CostModel cost{};
  StorePolicy stores = StorePolicy::prefetched;
  Tracing trace = Tracing::on;                              ///< what each PU does is recorded, span by span
  BlockChanges block_changes = BlockChanges::written_back;  ///< of `fused`; `levels` writes all back
};

/// Hands tiles to PUs (paper 2.2.3, 2.2.5, 3.2). Tasks are never equal units: big ones go first, and
/// whoever is free takes the next. The result does not depend on who took what.
class Scheduler {
 public:
  /// `palette_entries`: of the largest skeleton.
  Scheduler(const ScheduleOptions& options, std::size_t palette_entries);

  /// Room for so many agents, so that update() does not allocate.
  void reserve(std::size_t agents);

  /// For updates of so many agents.
  void record_trace(Tracing tracing, std::size_t agents);

  /// How palettes are written from the next update on.
  void set_stores(StorePolicy stores) { options_.stores = stores; }

  /// Divides the stores anew, at a frame boundary.
  void set_plan(const LocalStorePlan& plan);

  /// First updates the graphs that `shared` work asks for, whose states others read, then poses `agents`, sorted into
  /// tiles. The executor runs one job a PU.
  void update(std::span<const UpdateContext> contexts, std::span<const AgentWork> shared, const WorkInRuns& agents,
              Executor& executor);

  std::span<const ProcessingUnit> units() const { return units_; }
  /// Of the agents of the last update.
  const WorkOrder& order() const { return order_; }
  /// Of the last update; its clocks make milliseconds of the units' traces.
  const UpdateTime& time() const { return time_; }
  const ScheduleOptions& options() const { return options_; }

 private:
  std::span<int> shares_for(double nanoseconds);
  void collect_entities(std::span<const UpdateContext> contexts, std::span<const AgentWork> work);
  void run_fused(std::span<const UpdateContext> contexts, std::span<const AgentWork> work, double task_ns,
                 Executor& executor);
  void run_updates(std::span<const UpdateContext> contexts, std::span<const EntityUpdate> updates,
                   const LocalStorePlan& plan, Executor& executor);
  void run_entities(std::span<const UpdateContext> contexts, std::span<const AgentWork> work, Executor& executor);
  void run_palettes(std::span<const UpdateContext> contexts, std::span<const AgentWork> work, double nanoseconds,
                    Executor& executor);
  template <typename RunUnit>
  void on_units(Executor& executor, RunUnit&& run_unit);

  ScheduleOptions options_;
  std::vector<ProcessingUnit> units_;
  WorkOrder order_;
  TileCutter cutter_;
  std::span<const Tile> tiles_;                        // of the cutter
  std::vector<int> shares_;                            // room for a share a PU
  std::span<int> used_shares_;                         // of the PUs that are worth waking
  std::vector<std::vector<EntityUpdate>> priorities_;  // [i] entities of priority highest - i; [0] players
  TaskQueue queue_;
  UpdateTime time_;
};

}  // namespace throng::anim
