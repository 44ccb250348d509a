#include "engine/anim/run/scheduler.h"

#include <algorithm>

#include "engine/anim/base/misuse.h"
#include "engine/anim/base/room.h"
#include "engine/anim/base/zone.h"

namespace throng::anim {
namespace {

// Spans of a trace: enough for every task of a few thousand agents in any schedule, and 3 MiB a PU at most.
constexpr std::size_t spans_an_agent = 12;
constexpr std::size_t few_spans = 64;
constexpr std::size_t most_spans = std::size_t{1} << 16U;

/// Returns the predicted nanoseconds of one entity in `levels`.
double cost_of(const EntityKind& kind, int packets, const CostModel& cost) {
  if (kind.sources == nullptr) return cost.agent + packets * cost.player_packet;
  return cost.agent + (kind.whole_pose() ? kind.whole_pose_work * cost.post_process : packets * cost.blender_packet);
}

}  // namespace

Scheduler::Scheduler(const ScheduleOptions& options, std::size_t palette_entries)
    : options_(options), palette_entries_(palette_entries), queue_(options.pus) {
  units_.reserve(static_cast<std::size_t>(options.pus));
  for (int pu = 0; pu < options.pus; ++pu) units_.emplace_back(options.local_store_bytes, palette_entries);
  set_plan(options.plan);
  priorities_.resize(PoseProgram::max_depth);
  shares_.resize(static_cast<std::size_t>(options.pus) + 1);
  is_waiting_ = std::vector<std::atomic<bool>>(static_cast<std::size_t>(options.pus));
}

void Scheduler::set_plan(const LocalStorePlan& plan) {
  options_.plan = plan;
  for (ProcessingUnit& unit : units_) unit.set_plan(plan);
}

void Scheduler::record_trace(Tracing tracing, std::size_t agents) {
  options_.trace = tracing;
  const std::size_t spans = tracing == Tracing::off ? 0 : std::min(agents * spans_an_agent + few_spans, most_spans);
  for (ProcessingUnit& unit : units_) unit.trace().reserve(spans, tracing);
}

void Scheduler::reserve(std::size_t agents) {
  constexpr std::size_t usual_entities = 4;  // of one priority
  order_.reserve(agents);
  cutter_.reserve(agents);
  record_trace(options_.trace, agents);
  if (options_.schedule == Schedule::fused) return;
  make_room(priorities_[0], agents * usual_entities);
  for (std::size_t i = 1; i < usual_entities; ++i) make_room(priorities_[i], agents * 2);
}

void Scheduler::update(std::span<const UpdateContext> contexts, std::span<const AgentWork> shared,
                       const WorkInRuns& agents, Executor& executor) {
  time_.begin();
  for (int pu = 0; pu < options_.pus; ++pu) {
    units_[static_cast<std::size_t>(pu)].begin_update(time_.first_tick, pu, *contexts.front().assets.kernels);
  }
  units_.front().trace().open(TraceSpan::Kind::schedule);
  for (const UpdateContext& context : contexts) context.pools->guard_blocks();
  if (!shared.empty()) run_entities(contexts, shared, executor);
  units_.front().trace().open(TraceSpan::Kind::schedule);
  order_.sort(agents);
  const std::span<const AgentWork> work = order_.work();
  if (!work.empty()) {
    const double nanoseconds = order_.predicted();
    cut_ = cutter_.cut(contexts, order_, options_.plan, options_.schedule, options_.cost, shares_for(nanoseconds));
    if (options_.schedule == Schedule::fused) {
      run_fused(contexts, work, nanoseconds / static_cast<double>(cut_.tiles.size()), executor);
    } else {
      run_entities(contexts, work, executor);
      run_palettes(contexts, work, nanoseconds, executor);
    }
  }
  for (const UpdateContext& context : contexts) context.pools->release_blocks();
  for (ProcessingUnit& unit : units_) unit.trace().close(TraceSpan::Kind::wait);
  time_.end();
}

std::span<int> Scheduler::shares_for(double nanoseconds) {
  const int pus = pus_worth_waking(nanoseconds, options_.pus, options_.cost);
  used_shares_ = std::span(shares_).first(static_cast<std::size_t>(pus) + 1);
  return used_shares_;
}

template <typename RunUnit>
void Scheduler::on_units(Executor& executor, RunUnit&& run_unit) {
  struct Context {
    Scheduler* scheduler;
    RunUnit* run_unit;
  } shared{this, &run_unit};
  const int jobs = static_cast<int>(used_shares_.size()) - 1;
  queue_.open(used_shares_);
  for (int pu = 0; pu < jobs; ++pu) is_waiting_[static_cast<std::size_t>(pu)].store(true, std::memory_order_relaxed);
  units_.front().trace().close(TraceSpan::Kind::schedule);
  const auto run = [](void* context, int pu) {
    const auto& job = *static_cast<Context*>(context);
    if (!job.scheduler->begin_job(pu)) return;
    const Zone zone("PU", pu);
    (*job.run_unit)(job.scheduler->units_[static_cast<std::size_t>(pu)], TaskQueue::Taker(job.scheduler->queue_, pu));
  };
  executor.run(jobs, {run, &shared});
  for (int pu = 0; pu < jobs; ++pu) {
    if (is_waiting_[static_cast<std::size_t>(pu)].exchange(false)) {
      report_misuse({"Executor::run", "an executor runs each of its jobs before it returns"});
    }
  }
}

// A job that a host's executor runs twice, or makes up, does nothing.
bool Scheduler::begin_job(int pu) {
  const bool exists = pu >= 0 && static_cast<std::size_t>(pu) < is_waiting_.size();
  if (exists && is_waiting_[static_cast<std::size_t>(pu)].exchange(false)) return true;
  report_misuse({"Executor::run", "an executor runs jobs 0 to count - 1, each once"});
  return false;
}

void Scheduler::run_fused(std::span<const UpdateContext> contexts, std::span<const AgentWork> work, double task_ns,
                          Executor& executor) {
  on_units(executor, [&](ProcessingUnit& unit, TaskQueue::Taker queue) {
    FusedTasks tasks(contexts, work, cut_, queue, unit.store(), unit.tile_lists(),
                     {.unseen = unit.unseen(), .policy = options_.stores}, options_.block_changes);
    unit.run(tasks, options_.double_buffering, task_ns);
    contexts.front().assets.kernels->fence_stores();
    unit.activity().tasks += tasks.tiles_done();
    unit.activity().agents += tasks.agents_done();
  });
}

void Scheduler::run_entities(std::span<const UpdateContext> contexts, std::span<const AgentWork> work,
                             Executor& executor) {
  collect_entities(contexts, work);
  const LocalStorePlan one_at_a_time{
      .fetch_bytes = options_.plan.all_fetch_bytes(), .fetch_buffers = 1, .scratch_bytes = options_.plan.scratch_bytes};
  for (std::vector<EntityUpdate>& updates : priorities_) {
    const auto large = std::partition(updates.begin(), updates.end(), [&](const EntityUpdate& update) {
      return update.program().needs.entity_bytes <= options_.plan.fetch_bytes;
    });
    run_updates(contexts, {updates.begin(), large}, options_.plan, executor);
    run_updates(contexts, {large, updates.end()}, one_at_a_time, executor);
  }
}

// Updates that need both fetch buffers go without double buffering.
void Scheduler::run_updates(std::span<const UpdateContext> contexts, std::span<const EntityUpdate> updates,
                            const LocalStorePlan& plan, Executor& executor) {
  if (updates.empty()) return;
  const DoubleBuffering mode = plan.fetch_buffers == 1 ? DoubleBuffering::off : options_.double_buffering;
  double total = 0;
  for (const EntityUpdate& update : updates) total += update.cost * cost_step;
  cut_shares(
      static_cast<int>(updates.size()), [&](int task) { return int{updates[static_cast<std::size_t>(task)].cost}; },
      shares_for(total));
  const double task_ns = total / static_cast<double>(updates.size());
  on_units(executor, [&](ProcessingUnit& unit, TaskQueue::Taker queue) {
    unit.divide_store(plan);
    EntityTasks tasks(contexts, updates, queue, unit.store());
    unit.run(tasks, mode, task_ns);
    unit.divide_store(options_.plan);
    unit.activity().tasks += tasks.entities_done();
  });
}

void Scheduler::run_palettes(std::span<const UpdateContext> contexts, std::span<const AgentWork> work,
                             double nanoseconds, Executor& executor) {
  cut_shares(
      static_cast<int>(cut_.tiles.size()),
      [this](int tile) { return static_cast<double>(cut_.tiles[static_cast<std::size_t>(tile)].cost); },
      shares_for(nanoseconds));
  const double task_ns = options_.cost.tile_packet;
  on_units(executor, [&](ProcessingUnit& unit, TaskQueue::Taker queue) {
    PaletteTasks tasks(contexts, work, cut_.tiles, queue, unit.store(),
                       {.unseen = unit.unseen(), .policy = options_.stores});
    unit.run(tasks, options_.double_buffering, task_ns);
    contexts.front().assets.kernels->fence_stores();
    unit.activity().tasks += tasks.tiles_done();
    unit.activity().agents += tasks.agents_done();
  });
}

// The priorities are the paper's: a player has the highest, and a reader has one below the lowest of its sources.
void Scheduler::collect_entities(std::span<const UpdateContext> contexts, std::span<const AgentWork> work) {
  for (std::vector<EntityUpdate>& updates : priorities_) updates.clear();
  for (const AgentWork& agent : work) {
    const UpdateContext& context = contexts[agent.skeleton];
    const std::vector<PoseStep>& steps = agent.program->steps;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      if (steps[i].is_shared()) continue;
      priorities_[steps[i].below_highest].push_back(
          {.agent = &agent,
           .cost = cost_in_steps(
               cost_of(*steps[i].layout(*context.pools).kind, context.packets(agent.level), options_.cost)),
           .step = static_cast<std::uint8_t>(i)});
    }
  }
}

}  // namespace throng::anim
