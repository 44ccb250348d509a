#include "engine/anim/run/scheduler.h"

#include <algorithm>
#include <array>

namespace throng::anim {
namespace {

constexpr std::size_t cost_classes = std::size_t{max_bone_levels} * (BlendTree::max_entities + 1);

// Tiles of more bones and larger trees cost more; agents of one class are equal enough to share a tile.
std::size_t cost_class(const AgentWork& work) {
  return std::size_t{work.level} * (BlendTree::max_entities + 1) +
         static_cast<std::size_t>(BlendTree::max_entities - work.entity_count);
}

}  // namespace

Scheduler::Scheduler(const ScheduleOptions& options, std::size_t palette_entries)
    : options_(options), queue_(options.pus) {
  units_.reserve(static_cast<std::size_t>(options.pus));
  for (int pu = 0; pu < options.pus; ++pu) {
    units_.emplace_back(options.local_store_bytes, palette_entries);
    units_.back().store().divide(options.plan.fetch_bytes, options.double_buffering == DoubleBuffering::off ? 1 : 2,
                                 options.plan.scratch_bytes);
  }
  priorities_.resize(BlendTree::max_players);
}

void Scheduler::reserve(std::size_t agents) {
  sorted_.reserve(agents);
  tiles_.reserve(agents);
  if (options_.schedule == Schedule::fused) return;
  priorities_[0].reserve(agents * BlendTree::max_players);
  for (std::size_t i = 1; i < priorities_.size(); ++i) priorities_[i].reserve(agents * 2);
}

void Scheduler::update(const UpdateContext& context, std::span<const AgentWork> agents, Executor& executor) {
  const Trace::Clock::time_point start = Trace::Clock::now();
  for (ProcessingUnit& unit : units_) unit.begin_update(start);
  if (agents.empty()) return;
  const std::span<const AgentWork> work = sorted(agents);
  cut_tiles(work);
  context.pools->guard_blocks();
  if (options_.schedule == Schedule::fused) {
    run_fused(context, work, executor);
  } else {
    run_levels(context, work, executor);
  }
  context.pools->release_blocks();
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

void Scheduler::cut_tiles(std::span<const AgentWork> work) {
  tiles_.clear();
  const auto width = static_cast<std::uint32_t>(options_.plan.width);
  for (std::uint32_t first = 0; first < work.size();) {
    std::uint32_t count = 1;
    while (count < width && first + count < work.size() && work[first + count].level == work[first].level) ++count;
    tiles_.push_back({first, count});
    first += count;
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

void Scheduler::run_fused(const UpdateContext& context, std::span<const AgentWork> work, Executor& executor) {
  on_all_units(static_cast<int>(tiles_.size()), executor, [&](ProcessingUnit& unit, TaskQueue::Taker queue) {
    FusedTasks tasks(context, work, tiles_, queue, unit.store(), options_.plan.width, unit.unseen());
    unit.run(tasks, options_.double_buffering);
    unit.activity().tasks += tasks.tiles_done();
    unit.activity().agents += tasks.agents_done();
  });
}

void Scheduler::run_levels(const UpdateContext& context, std::span<const AgentWork> work, Executor& executor) {
  collect_entities(work);
  for (const std::vector<EntityUpdate>& updates : priorities_) {
    if (updates.empty()) continue;
    on_all_units(static_cast<int>(updates.size()), executor, [&](ProcessingUnit& unit, TaskQueue::Taker queue) {
      EntityTasks tasks(context, updates, queue, unit.store());
      unit.run(tasks, options_.double_buffering);
      unit.activity().tasks += tasks.entities_done();
    });
  }
  on_all_units(static_cast<int>(tiles_.size()), executor, [&](ProcessingUnit& unit, TaskQueue::Taker queue) {
    PaletteTasks tasks(context, work, tiles_, queue, unit.store(), options_.plan.width, unit.unseen());
    unit.run(tasks, options_.double_buffering);
    unit.activity().tasks += tasks.tiles_done();
    unit.activity().agents += tasks.agents_done();
  });
}

// Priorities as the paper has them: a player is highest, a blender one below the lowest of its sources.
void Scheduler::collect_entities(std::span<const AgentWork> work) {
  struct Source {
    Handle entity;
    std::size_t depth;
  };
  for (std::vector<EntityUpdate>& updates : priorities_) updates.clear();
  for (const AgentWork& agent : work) {
    std::array<Source, BlendTree::max_players> stack;
    std::size_t top = 0;
    for (const Handle entity : agent.tree->all()) {
      EntityUpdate update{.entity = entity, .from = {}, .to = {}, .delta = agent.delta, .level = agent.level};
      std::size_t depth = 0;
      if (entity.pool() == EntityPools::ease_blenders) {
        const Source to = stack[--top];
        const Source from = stack[--top];
        depth = std::max(from.depth, to.depth) + 1;
        update.from = from.entity;
        update.to = to.entity;
      }
      priorities_[depth].push_back(update);
      stack[top++] = {entity, depth};
    }
  }
}

}  // namespace throng::anim
