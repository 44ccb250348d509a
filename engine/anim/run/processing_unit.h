#pragma once

#include <chrono>
#include <cstdint>
#include <memory>

#include "engine/anim/run/fused/notes.h"
#include "engine/anim/run/local_store_plan.h"
#include "engine/anim/run/store/double_buffer.h"
#include "engine/anim/run/store/local_store.h"
#include "engine/anim/run/store/trace.h"

namespace throng::anim {

/// What one PU did in one update.
struct PuActivity {
  std::uint32_t tasks = 0;
  std::uint32_t agents = 0;
  double busy_ms = 0;
  CopyCounts copies;
};

/// A worker with a local memory of its own: runs tasks of any kind through it.
class alignas(block_alignment) ProcessingUnit {
 public:
  /// `palette_entries`: of the skeleton, for palettes that nobody sees.
  ProcessingUnit(std::size_t local_store_bytes, std::size_t palette_entries)
      : store_(local_store_bytes),
        unseen_(allocate_aligned(palette_stride(palette_entries, PaletteFormat::matrices))) {}

  /// While no task is under way.
  void divide_store(const LocalStorePlan& plan) {
    store_.divide(plan.fetch_bytes, plan.fetch_buffers, plan.scratch_bytes);
    engine_.reserve(2 * plan.all_fetch_bytes() / entity_header_bytes +
                    2 * widest_strip);  // one tile out while one comes in
  }

  LocalStore& store() { return store_; }
  const LocalStore& store() const { return store_; }
  FusedNotes& fused_notes() { return *fused_notes_; }
  PaletteMatrix* unseen() const { return reinterpret_cast<PaletteMatrix*>(unseen_.get()); }

  /// `task_ns`: what one is predicted to take.
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

  void begin_update(std::uint64_t tick, const Kernels& kernels) {
    engine_.use(kernels);
    activity_ = {};
    trace_.begin(tick);
  }
  Trace& trace() { return trace_; }
  const Trace& trace() const { return trace_; }
  PuActivity& activity() { return activity_; }
  const PuActivity& activity() const { return activity_; }

 private:
  LocalStore store_;
  AlignedBytes unseen_;
  std::unique_ptr<FusedNotes> fused_notes_ = std::make_unique_for_overwrite<FusedNotes>();
  CopyEngine engine_;
  PuActivity activity_;
  Trace trace_;
};

}  // namespace throng::anim
