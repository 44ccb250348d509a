#pragma once

#include <atomic>
#include <span>
#include <vector>

#include "throng/host.h"

#include "engine/anim/run/fused/tasks.h"
#include "engine/anim/run/levels/level_tasks.h"
#include "engine/anim/run/processing_unit.h"
#include "engine/anim/run/program/agent_work.h"
#include "engine/anim/run/program/work_order.h"
#include "engine/anim/run/schedule_options.h"
#include "engine/anim/run/store/task_queue.h"
#include "engine/anim/run/tile_cutter.h"

namespace throng::anim {

/// Poses the agents of a frame (paper 2.2.3, 2.2.5, 3.2). Here are the steps of an update, in this order, and why.
///
/// 1. *Guard the pools* (base/guard.h). Under the address sanitizer all blocks are poisoned until the update is over.
///    The copy engine alone reaches them, so a kernel that reads main memory instead of its local store is caught.
/// 2. *Update shared graphs*, by `levels` in either schedule. Agents of many tiles read their states, so the states
///    must be whole before the first tile is fetched. No PU waits for a shared graph later.
/// 3. *Order the work* (program/work_order.h), on the calling thread, which is PU 0. Agents are grouped by what a tile
///    must have in common: skeleton, bone level, held or streaming. The dearest groups go first, because a large task
///    that begins last keeps all other PUs waiting. The list is walked by runs of agents with one program and equal
///    cost: a crowd has few runs.
/// 4. *Cut tiles and shares* (tile_cutter.h). Tasks are never equal units, so each PU gets a share of equal predicted
///    cost. A tile has as many characters as the local store holds. A tile that straddles two shares is cut where that
///    gains more than another tile costs. A PU that would have too little to do stays parked, because waking it takes
///    longer. A prediction that is wrong costs time and changes no pose.
/// 5. *Run the PUs*, one job each. A PU begins with its own share, whose blocks and palettes are in its caches from the
///    frame before, and then helps the others (store/task_queue.h). Jobs never wait for each other, so a host whose
///    job system has fewer threads than there are PUs finishes, too.
///    - `fused` is one round without a barrier. A task is a tile from blocks to palettes (fused/tasks.h).
///    - `levels` has a round for each priority: players first, then their readers, because a source has to be back in
///      main memory before a reader fetches it. The rare update that needs both fetch buffers has a round of its own
///      after the others of its priority. The last round makes palettes, tile by tile.
/// 6. *Fence the stores*, at the end of each job that wrote palettes. Palettes may be streamed past the caches, and the
///    thread that draws must not see them half written.
/// 7. *Release the pools* and close the traces. All of a PU's time is in some span of its trace.
///
/// A task touches three things: the local store of its PU, read-only assets, and the palettes of its own agents. The
/// copy engine writes back the blocks of its own task, and no other task of the round reads these. That is why there is
/// no lock, why PUs share nothing but the heads of their queues, and why the result does not depend on the PU of a
/// task. Memory is set aside between frames, by reserve() and set_plan().
class Scheduler {
 public:
  /// Makes the PUs. `palette_entries` is the count of the largest skeleton.
  Scheduler(const ScheduleOptions& options, std::size_t palette_entries);

  /// Makes room for so many agents, so that update() does not allocate.
  void reserve(std::size_t agents);

  /// Sets the detail of traces, and makes room for updates of so many agents.
  void record_trace(Tracing tracing, std::size_t agents);

  /// Sets how palettes are written from the next update on.
  void set_stores(StorePolicy stores) { options_.stores = stores; }

  /// Divides the stores anew, at a frame boundary. Allocates.
  void set_plan(const LocalStorePlan& plan);

  /// Updates the graphs of `shared`, whose states others read, and then poses `agents`. The executor runs one job a PU.
  void update(std::span<const UpdateContext> contexts, std::span<const AgentWork> shared, const WorkInRuns& agents,
              Executor& executor);

  std::span<const ProcessingUnit> units() const { return units_; }
  /// Returns the agents of the last update.
  const WorkOrder& order() const { return order_; }
  /// Returns the time of the last update. Its clocks make milliseconds of the units' traces.
  const UpdateTime& time() const { return time_; }
  const ScheduleOptions& options() const { return options_; }
  /// Returns the most entries of a palette that it has room for.
  int palette_entries() const { return static_cast<int>(palette_entries_); }

 private:
  bool begin_job(int pu);
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
  CutWork cut_;                                        // the result of the cutter
  std::vector<int> shares_;                            // room for a share a PU
  std::span<int> used_shares_;                         // the shares of the PUs that are worth waking
  std::vector<std::vector<EntityUpdate>> priorities_;  // [i] entities of priority highest - i; [0] players
  std::vector<std::atomic<bool>> is_waiting_;          // [pu] its job was handed out and has not begun
  std::size_t palette_entries_;
  TaskQueue queue_;
  UpdateTime time_;
};

}  // namespace throng::anim
