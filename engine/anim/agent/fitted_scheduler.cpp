#include "engine/anim/agent/fitted_scheduler.h"

#include <algorithm>
#include <cassert>

#include "engine/anim/run/store/store_choice.h"

namespace throng::anim {
namespace {

void convert(Population& population, const SystemOptions& options) {
  const bool fused = options.schedule == Schedule::fused;
  population.convert(fused ? Residency::transient : Residency::resident, options.stream);
}

}  // namespace

const char* FittedScheduler::fault() const {
  if (threads_ == nullptr || threads_->are_here()) return nullptr;
  return "its threads are in the process that this one was forked from: make another crowd here, or configure this one";
}

void FittedScheduler::refresh_contexts(const Population& population) {
  const Kernels& kernels = options_.kernels == nullptr ? best_kernels() : *options_.kernels;
  contexts_.clear();
  for (const std::unique_ptr<CharacterAgents>& character : population.characters()) {
    contexts_.push_back(character->context(kernels));
    contexts_.back().assets.prefetch = options_.prefetch;
    if (character->character->hierarchy.packs()) contexts_.back().palette_format = options_.palettes;
  }
}

void FittedScheduler::set_hashes(std::span<std::uint64_t> hashes) {
  for (UpdateContext& context : contexts_) context.hashes = hashes;
}

void FittedScheduler::set_joints(std::span<const PaletteDestination> joints_to) {
  for (UpdateContext& context : contexts_) context.joints_to = joints_to;
}

void FittedScheduler::record_trace(Tracing tracing, std::uint32_t agents) {
  options_.trace = tracing;
  scheduler_->record_trace(tracing, agents);
}

LocalStoreDemand FittedScheduler::demand(const Population& population) const { return demand(population, options_); }

LocalStoreDemand FittedScheduler::demand(const Population& population, const SystemOptions& options) const {
  LocalStoreDemand demand = local_store_demand(population.characters(), options.stream);
  demand.schedule = options.schedule;
  demand.double_buffering = options.double_buffering;
  return demand;
}

Status FittedScheduler::configure(Population& population, const SystemOptions& options) {
  if (Status valid = check(options); !valid) return valid;
  convert(population, options);
  refresh_contexts(population);
  const LocalStoreDemand needs = demand(population, options);
  const std::size_t store_bytes =
      options.local_store_bytes == 0 ? automatic_local_store(contexts_, needs) : options.local_store_bytes;
  const Result<LocalStorePlan> plan = plan_local_store(contexts_, needs, store_bytes, options.tile);
  if (!plan) {
    convert(population, options_);
    return plan.error();
  }
  if (options.executor != nullptr) {
    threads_.reset();
  } else if (threads_ == nullptr || options.pus != options_.pus || !threads_->are_here()) {
    threads_ = std::make_unique<PuThreads>(options.pus);
  }
  options_ = options;
  if (threads_ != nullptr) options_.pus = threads_->pus();
  for (const std::unique_ptr<CharacterAgents>& character : population.characters()) {
    character->reserve_fades(options.stream, character->agents.alive_count());
  }
  refresh_contexts(population);
  make_scheduler(population, *plan, store_bytes);
  return Done{};
}

Status FittedScheduler::take_character(const Population& population, std::uint32_t character) {
  refresh_contexts(population);
  const LocalStoreDemand needs = demand(population);
  if (Status fits = fit(population, needs); !fits) return fits;
  // PUs write palettes without a destination to a place of their own, which has room for the largest.
  if (population.characters()[character]->skeleton().palette_count() > scheduler_->palette_entries()) {
    make_scheduler(population, scheduler_->options().plan, scheduler_->options().local_store_bytes);
  }
  return Done{};
}

void FittedScheduler::make_scheduler(const Population& population, const LocalStorePlan& plan,
                                     std::size_t store_bytes) {
  std::size_t most_entries = 0;
  for (const std::unique_ptr<CharacterAgents>& character : population.characters()) {
    const std::size_t for_joints = (character->joint_bytes() + sizeof(PaletteMatrix) - 1) / sizeof(PaletteMatrix);
    most_entries =
        std::max({most_entries, static_cast<std::size_t>(character->skeleton().palette_count()), for_joints});
  }
  scheduler_ = std::make_unique<Scheduler>(ScheduleOptions{.schedule = options_.schedule,
                                                           .double_buffering = options_.double_buffering,
                                                           .plan = plan,
                                                           .local_store_bytes = store_bytes,
                                                           .pus = options_.pus,
                                                           .cost = options_.cost,
                                                           .stores = store_policy(population),
                                                           .trace = options_.trace},
                                           most_entries);
  ++version_;
  scheduler_->reserve(population.numbers().number_limit());
}

template <typename Update>
Status FittedScheduler::update_parts(Population& population, std::uint32_t agent, Update&& update) {
  AgentGraphs& graphs = population.character_of(agent).agents;
  const std::uint32_t index = population.numbers().member(agent).index;
  const EntityBuilder build = population.builder(agent);
  const bool is_done = update(graphs, build, index);
  Status updated = settle(population, agent, [&] { return is_done ? Status(Done{}) : graphs.rebuild(build, index); });
  if (updated) return updated;
  return settle(population, agent, [&] { return graphs.rebuild(build, index, AgentGraphs::Fades::are_cut); });
}

Status FittedScheduler::update_channels(Population& population, std::uint32_t agent) {
  return update_parts(population, agent, [](AgentGraphs& graphs, const EntityBuilder& build, std::uint32_t index) {
    return graphs.update(build, index);
  });
}

Status FittedScheduler::update_channel(Population& population, std::uint32_t agent, std::size_t place) {
  return update_parts(population, agent, [&](AgentGraphs& graphs, const EntityBuilder& build, std::uint32_t index) {
    return graphs.update_alone(build, index, *graphs.channel(index, place).part, AgentGraphs::Entities::may_change);
  });
}

void FittedScheduler::update_due_channels(Population& population, std::uint32_t character) {
  const AgentGraphs& graphs = population.characters()[character]->agents;
  for (std::uint32_t agent = 0; agent < population.numbers().number_limit(); ++agent) {
    const Member& member = population.numbers().member(agent);
    const bool is_its = member.alive() && member.character == character;
    if (!is_its || graphs.next_update(member.index) > population.clock()) continue;
    [[maybe_unused]] const Status updated = update_channels(population, agent);
    assert(updated && "a channel changed by itself to a graph that cannot be run");
  }
}

// After a change an agent may ask more of the local store than any did before.
Status FittedScheduler::fit(const Population& population, std::uint32_t agent) {
  const StoreNeeds& needs = population.graph(agent).program->needs;
  const UpdateContext& context = contexts_[population.numbers().member(agent).character];
  if (plan_holds(scheduler_->options().plan, context, options_.schedule, needs)) return Done{};
  return fit(population, demand(population));
}

Status FittedScheduler::fit(const Population& population, const LocalStoreDemand& needs) {
  const std::size_t now = scheduler_->options().local_store_bytes;
  std::size_t bytes = now;
  if (options_.local_store_bytes == 0) bytes = std::max(bytes, automatic_local_store(contexts_, needs));
  const Result<LocalStorePlan> plan = plan_local_store(contexts_, needs, bytes, options_.tile);
  if (!plan) return plan.error();
  if (bytes == now) {
    scheduler_->set_plan(*plan);
  } else {
    make_scheduler(population, *plan, bytes);
  }
  return Done{};
}

StorePolicy FittedScheduler::store_policy(const Population& population) const {
  if (options_.stores) return *options_.stores;
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < contexts_.size(); ++i) {
    bytes += population.characters()[i]->palette_bytes(contexts_[i].palette_format);
  }
  return store_policy_for(bytes, options_.cached_bytes == 0 ? named_cached_bytes() : options_.cached_bytes);
}

void FittedScheduler::reserve(const Population& population) {
  scheduler_->reserve(population.numbers().number_limit());
  scheduler_->set_stores(store_policy(population));
}

}  // namespace throng::anim
