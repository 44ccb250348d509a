#pragma once

#include <chrono>
#include <cstdint>

#include "engine/anim/run/fused/tile_lists.h"
#include "engine/anim/run/local_store_plan.h"
#include "engine/anim/run/store/double_buffer.h"
#include "engine/anim/run/store/local_store.h"
#include "engine/anim/run/store/trace.h"
#include "engine/anim/run/update_report.h"

namespace throng::anim {

/// A worker with a local memory of its own. It runs tasks of any kind through that memory.
class alignas(block_alignment) ProcessingUnit {
 public:
  /// Makes a PU. `palette_entries` is the count of the largest skeleton, for palettes without a destination.
  ProcessingUnit(std::size_t local_store_bytes, std::size_t palette_entries)
      : store_(local_store_bytes),
        unseen_(allocate_aligned(palette_stride(palette_entries, PaletteFormat::matrices))) {}

  /// Divides the store, while no task is under way, and makes the lists beside it long enough. Allocates.
  void set_plan(const LocalStorePlan& plan) {
    divide_store(plan);
    engine_.reserve(2 * plan.all_fetch_bytes() / entity_header_bytes +
                    2 * widest_strip);  // one tile out while one comes in
    tile_lists_.reserve(plan.fetch_bytes);
  }
  /// Divides the store for tasks that need no longer lists.
  void divide_store(const LocalStorePlan& plan) {
    store_.divide(plan.fetch_bytes, plan.fetch_buffers, plan.scratch_bytes);
  }

  LocalStore& store() { return store_; }
  const LocalStore& store() const { return store_; }
  TileLists& tile_lists() { return tile_lists_; }
  /// Returns the bytes that the tasks of `fused` keep in memory beside the store. They depend on the plan alone.
  std::size_t list_bytes() const { return tile_lists_.bytes(); }
  PaletteMatrix* unseen() const { return reinterpret_cast<PaletteMatrix*>(unseen_.get()); }

  /// Runs tasks until there are no more. `task_ns` is the time that one task is predicted to take.
  template <typename Tasks>
  void run(Tasks& tasks, DoubleBuffering mode, double task_ns) {
    trace_.close(TraceSpan::Kind::wait);
    trace_.begin_tasks(task_ns);
    const auto start = std::chrono::steady_clock::now();
    run_tasks(tasks, engine_, mode, trace_);
    trace_.end_tasks();
    activity_.busy_ms += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    activity_.copies += engine_.take_counts();
  }

  void begin_update(std::uint64_t tick, int pu, const Kernels& kernels) {
    engine_.use(kernels);
    activity_ = {};
    trace_.begin(tick, pu);
  }
  Trace& trace() { return trace_; }
  const Trace& trace() const { return trace_; }
  PuActivity& activity() { return activity_; }
  const PuActivity& activity() const { return activity_; }

 private:
  LocalStore store_;
  AlignedBytes unseen_;
  TileLists tile_lists_;
  CopyEngine engine_;
  PuActivity activity_;
  Trace trace_;
};

}  // namespace throng::anim
