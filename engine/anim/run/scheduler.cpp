#include "engine/anim/run/scheduler.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace throng::anim {
namespace {

// Programs that are longer cost alike.
constexpr std::size_t longest = 15;
constexpr std::size_t cost_classes = most_skeletons * 2 * max_bone_levels * (longest + 1);

// Agents of one class are equal enough to share a tile; held tiles, more bones and larger graphs cost more.
std::size_t cost_class(const AgentWork& work) {
  const std::size_t group = (work.skeleton * std::size_t{2} + (work.held ? 0U : 1U)) * max_bone_levels + work.level;
  return group * (longest + 1) + longest - std::min<std::size_t>(work.entity_count, longest);
}

bool share_a_tile(const AgentWork& a, const AgentWork& b) {
  return a.skeleton == b.skeleton && a.level == b.level && a.held == b.held;
}

}  // namespace

Scheduler::Scheduler(const ScheduleOptions& options, std::size_t palette_entries)
    : options_(options), queue_(options.pus) {
  units_.reserve(static_cast<std::size_t>(options.pus));
  for (int pu = 0; pu < options.pus; ++pu) units_.emplace_back(options.local_store_bytes, palette_entries);
  set_plan(options.plan);
  priorities_.resize(PoseProgram::max_depth);
}

void Scheduler::set_plan(const LocalStorePlan& plan) {
  options_.plan = plan;
  for (ProcessingUnit& unit : units_) unit.divide_store(plan);
}

void Scheduler::reserve(std::size_t agents) {
  constexpr std::size_t usual_entities = 4;  // of one priority
  sorted_.reserve(agents);
  tiles_.reserve(agents);
  if (options_.schedule == Schedule::fused) return;
  priorities_[0].reserve(agents * usual_entities);
  for (std::size_t i = 1; i < usual_entities; ++i) priorities_[i].reserve(agents * 2);
}

void Scheduler::update(std::span<const UpdateContext> contexts, std::span<const AgentWork> shared,
                       std::span<const AgentWork> agents, Executor& executor) {
  const Trace::Clock::time_point start = Trace::Clock::now();
  for (ProcessingUnit& unit : units_) unit.begin_update(start);
  for (const UpdateContext& context : contexts) context.pools->guard_blocks();
  if (!shared.empty()) run_entities(contexts, shared, executor);
  if (!agents.empty()) {
    const std::span<const AgentWork> work = sorted(agents);
    cut_tiles(contexts, work);
    if (options_.schedule == Schedule::fused) {
      run_fused(contexts, work, executor);
    } else {
      run_entities(contexts, work, executor);
      run_palettes(contexts, work, executor);
    }
  }
  store_choice_.note(agents.size(), busy_ms());
  for (const UpdateContext& context : contexts) context.pools->release_blocks();
}

double Scheduler::busy_ms() const {
  double sum = 0.0;
  for (const ProcessingUnit& unit : units_) sum += unit.activity().busy_ms;
  return sum;
}

// A stable counting sort: dearest class first. A crowd of one class, which is common, stays where it is.
std::span<const AgentWork> Scheduler::sorted(std::span<const AgentWork> work) {
  if (std::ranges::is_sorted(work, {}, cost_class)) return work;
  std::array<std::uint32_t, cost_classes + 1> starts{};
  for (const AgentWork& agent : work) ++starts[cost_class(agent) + 1];
  for (std::size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
  sorted_.resize(work.size());
  for (const AgentWork& agent : work) sorted_[starts[cost_class(agent)]++] = agent;
  return sorted_;
}

int Scheduler::tile_limit(const UpdateContext& context, const StoreNeeds& needs, const SharedSources& shared) const {
  if (options_.schedule == Schedule::levels) return options_.plan.width;
  return std::min(options_.plan.width, widest_fused_tile(context, needs, shared.bytes(*context.pools), options_.plan));
}

void Scheduler::cut_tiles(std::span<const UpdateContext> contexts, std::span<const AgentWork> work) {
  tiles_.clear();
  StoreNeeds needs;  // of the last tile
  SharedSources shared;
  int limit = 0;  // characters of these needs in a tile
  for (std::uint32_t i = 0; i < work.size(); ++i) {
    const UpdateContext& context = contexts[work[i].skeleton];
    const PoseProgram& program = *work[i].program;
    const bool joins = !tiles_.empty() && share_a_tile(work[tiles_.back().first], work[i]);
    StoreNeeds wider = needs;
    wider.widen(program.needs);
    if (joins && wider == needs && program.needs.shared == 0) {
      if (tiles_.back().count == static_cast<std::uint32_t>(limit)) tiles_.push_back({i, 0, needs});
      ++tiles_.back().count;
      continue;
    }
    SharedSources more = shared;
    const int wider_limit = joins && more.add(program) ? tile_limit(context, wider, more) : 0;
    if (joins && wider_limit > static_cast<int>(tiles_.back().count)) {
      ++tiles_.back().count;
      tiles_.back().needs = needs = wider;
      shared = more;
      limit = wider_limit;
      continue;
    }
    needs = program.needs;
    tiles_.push_back({i, 1, needs});
    shared = SharedSources(work.subspan(i, 1));
    limit = tile_limit(context, needs, shared);
    assert(limit > 0 && "a program that does not fit the local store was let in");
  }
}

template <typename RunUnit>
void Scheduler::on_all_units(int task_count, Executor& executor, RunUnit&& run_unit) {
  struct Context {
    Scheduler* scheduler;
    RunUnit* run_unit;
  } shared{this, &run_unit};
  queue_.open(task_count);
  const auto run = [](void* context, int pu) {
    const auto& job = *static_cast<Context*>(context);
    (*job.run_unit)(job.scheduler->units_[static_cast<std::size_t>(pu)], TaskQueue::Taker(job.scheduler->queue_, pu));
  };
  executor.run(options_.pus, {run, &shared});
}

void Scheduler::run_fused(std::span<const UpdateContext> contexts, std::span<const AgentWork> work,
                          Executor& executor) {
  const StorePolicy policy = store_choice_.policy_for(work.size());
  on_all_units(static_cast<int>(tiles_.size()), executor, [&](ProcessingUnit& unit, TaskQueue::Taker queue) {
    FusedTasks tasks(contexts, work, tiles_, queue, unit.store(), {.unseen = unit.unseen(), .policy = policy});
    unit.run(tasks, options_.double_buffering);
    contexts.front().assets.kernels->fence_stores();
    unit.activity().tasks += tasks.tiles_done();
    unit.activity().agents += tasks.agents_done();
  });
}

void Scheduler::run_entities(std::span<const UpdateContext> contexts, std::span<const AgentWork> work,
                             Executor& executor) {
  collect_entities(work);
  const LocalStorePlan one_at_a_time{
      .fetch_bytes = options_.plan.all_fetch_bytes(), .fetch_buffers = 1, .scratch_bytes = options_.plan.scratch_bytes};
  for (std::vector<EntityUpdate>& updates : priorities_) {
    const auto large = std::partition(updates.begin(), updates.end(), [&](const EntityUpdate& update) {
      return update.program->needs.entity_bytes <= options_.plan.fetch_bytes;
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
  on_all_units(static_cast<int>(updates.size()), executor, [&](ProcessingUnit& unit, TaskQueue::Taker queue) {
    unit.divide_store(plan);
    EntityTasks tasks(contexts, updates, queue, unit.store());
    unit.run(tasks, mode);
    unit.divide_store(options_.plan);
    unit.activity().tasks += tasks.entities_done();
  });
}

void Scheduler::run_palettes(std::span<const UpdateContext> contexts, std::span<const AgentWork> work,
                             Executor& executor) {
  const StorePolicy policy = store_choice_.policy_for(work.size());
  on_all_units(static_cast<int>(tiles_.size()), executor, [&](ProcessingUnit& unit, TaskQueue::Taker queue) {
    PaletteTasks tasks(contexts, work, tiles_, queue, unit.store(), {.unseen = unit.unseen(), .policy = policy});
    unit.run(tasks, options_.double_buffering);
    contexts.front().assets.kernels->fence_stores();
    unit.activity().tasks += tasks.tiles_done();
    unit.activity().agents += tasks.agents_done();
  });
}

// Priorities as the paper has them: a player is highest, what reads others one below the lowest of them.
void Scheduler::collect_entities(std::span<const AgentWork> work) {
  for (std::vector<EntityUpdate>& updates : priorities_) updates.clear();
  for (const AgentWork& agent : work) {
    const std::vector<PoseStep>& steps = agent.program->steps;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      if (steps[i].shared) continue;
      priorities_[steps[i].below_highest].push_back({.program = agent.program,
                                                     .delta = agent.delta,
                                                     .step = static_cast<std::uint8_t>(i),
                                                     .skeleton = agent.skeleton,
                                                     .level = agent.level});
    }
  }
}

}  // namespace throng::anim
