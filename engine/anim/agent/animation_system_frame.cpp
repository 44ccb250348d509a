// One frame: channels that are due, the work of each agent, the PUs, the hash.

#include <algorithm>
#include <array>
#include <cassert>
#include <new>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/base/hash.h"

namespace throng::anim {
namespace {

/// What follows from an agent's program and level: nearly always those of the one before.
struct AlikeAgents {
  const PoseProgram* program = nullptr;
  std::uint8_t level = 0;
  std::uint16_t cost = 0;
  bool held = false;
  bool look_ahead = true;  ///< they may be posed ahead of the clock

  bool include(const PoseProgram& other, std::uint8_t other_level) const {
    return program == &other && level == other_level;
  }
};

}  // namespace

void AnimationSystem::update(std::span<const AgentUpdate> agents) {
  ++frame_;
  report_ = {};
  begin_shared_work();
  begin_work(agents);
  scheduler_->update(contexts_, shared_work_, {work_, runs_}, executor());
  report_work(scheduler_->order());
  end_work();
}

void AnimationSystem::update_channels(std::uint32_t agent) {
  [[maybe_unused]] const Status updated =
      settle(agent, [&] { return agents(agent).update(builder(agent), local(agent)); });
  assert(updated && "a channel changed by itself to a graph that cannot be run");
}

bool AnimationSystem::update_shared(Cast& cast) {
  bool changed = false;
  for (std::uint32_t graph = 0; graph < cast.shared.count(); ++graph) {
    if (cast.shared.next_update(graph) > clock_) continue;
    [[maybe_unused]] const Handle root = cast.shared.graph(graph).root();
    [[maybe_unused]] const Status updated = cast.shared.update(shared_builder(cast, graph), graph);
    assert(updated && cast.shared.graph(graph).root() == root && "a shared channel changed to another state");
    changed = true;
  }
  if (changed) cast.shared.recompile();  // later graphs may read earlier ones, whose depth may have changed
  return changed;
}

void AnimationSystem::begin_shared_work() {
  shared_work_.clear();
  bool changed = false;
  for (const std::unique_ptr<Cast>& cast : casts_) changed = update_shared(*cast) || changed;
  [[maybe_unused]] const Status fits = changed ? fit_stores(demand(options_)) : Status(Done{});
  assert(fits && "a shared channel changed by itself to a graph that cannot be run");
  for (std::size_t cast = 0; cast < casts_.size(); ++cast) {
    const Agents& shared = casts_[cast]->shared;
    for (std::uint32_t graph = 0; graph < shared.count(); ++graph) {
      shared_work_.push_back({.program = shared.graph(graph).program,
                              .entities = shared.graph(graph).entities.data(),
                              .delta = clock_ - shared_posed_at_,
                              .agent = shared_owner | graph,
                              .skeleton = static_cast<std::uint8_t>(cast)});
    }
  }
  shared_posed_at_ = clock_;
}

void AnimationSystem::begin_work(std::span<const AgentUpdate> agents) {
  for (UpdateContext& context : contexts_)
    context.hashes = options_.hash ? std::span(agent_hashes_) : std::span(agent_hashes_).first(0);
  work_.resize(agents.size());
  // Nothing below moves these, and the compiler cannot know.
  const std::span<const Member> members = members_;
  const std::span<Ticks> posed_at = posed_at_;
  const Ticks now = clock_;
  AlikeAgents alike;
  AgentWork* work = work_.data();
  const auto listed = [&] { return static_cast<std::uint32_t>(work - work_.data()); };
  const auto end_run = [&] {
    if (!runs_.empty()) runs_.back().count = listed() - runs_.back().first;
  };
  runs_.clear();
  for (const AgentUpdate& update : agents) {
    const Member member = members[update.agent];
    const Agents& cast = casts_[member.cast]->agents;
    if (cast.next_update(member.local) <= now) [[unlikely]]
      update_channels(update.agent);
    const PoseGraph& graph = cast.graph(member.local);
    assert(update.level < max_bone_levels && update.fade_level < max_bone_levels && update.fade_halves <= 2);
    assert(!graph.program->steps.empty() && "an agent must play something before it is updated");
    if (!alike.include(*graph.program, update.level)) [[unlikely]] {
      end_run();
      runs_.push_back({.first = listed()});
      const PoseProgram& program = *graph.program;
      alike = {.program = &program,
               .level = update.level,
               .cost = predicted_cost(program, member.cast, update.level),
               .held = program.needs.held,
               .look_ahead = program.needs.shared == 0};
    }
    Ticks time = alike.look_ahead ? now + update.look_ahead : now;
    const Ticks before = posed_at[update.agent];
    if (time < before && !can_wind_back(update.agent)) [[unlikely]]
      time = before;
    posed_at[update.agent] = time;
    ::new (work++) AgentWork{.program = alike.program,
                             .entities = graph.entities.data(),
                             .delta = time - before,
                             .palette = update.palette,
                             .agent = update.agent,
                             .cost = alike.cost,
                             .skeleton = static_cast<std::uint8_t>(member.cast),
                             .level = update.level,
                             .fade_level = update.fade_level,
                             .fade_halves = update.fade_halves,
                             .held = alike.held};
  }
  end_run();
}

std::uint16_t AnimationSystem::predicted_cost(const PoseProgram& program, std::uint32_t cast, int level) const {
  return cost_in_steps(options_.cost.of_agent(program.parts, contexts_[cast].packets(level)));
}

void AnimationSystem::report_work(const WorkOrder& order) {
  std::array<std::array<std::uint64_t, max_bone_levels>, most_skeletons> agents_by_level{};
  for (const WorkRun& run : order.runs()) {
    const AgentWork& like = order.work()[run.first];
    agents_by_level[like.skeleton][like.level] += run.count;
  }
  report_.predicted_nanoseconds = order.predicted();
  report_.agents_updated = static_cast<std::uint32_t>(order.work().size());
  for (std::size_t cast = 0; cast < casts_.size(); ++cast) {
    const Skeleton& skeleton = casts_[cast]->skeleton();
    const std::size_t entry_bytes = palette_entry_bytes(contexts_[cast].palette_format);
    for (std::size_t level = 0; level < skeleton.level_bone_counts.size(); ++level) {
      const int bones = skeleton.level_bone_counts[level];
      const auto entries = static_cast<std::uint64_t>(palette_count_for_bones(skeleton, bones));
      report_.bones_evaluated += agents_by_level[cast][level] * static_cast<std::uint64_t>(bones);
      report_.palette_bytes += agents_by_level[cast][level] * entries * entry_bytes;
      const auto width = static_cast<std::uint64_t>(widest_strip);  // whatever the store holds: budgets decide by this
      const std::uint64_t tiles = (agents_by_level[cast][level] + width - 1) / width;
      report_.predicted_nanoseconds += static_cast<double>(tiles) * options_.cost.of_tile(packets_for(bones));
    }
  }
}

void AnimationSystem::end_work() {
  for (const ProcessingUnit& unit : scheduler_->units()) {
    report_.copies += unit.activity().copies;
  }
  if (!options_.hash) return;
  for (const AgentWork& work : work_) {
    agent_hashes_[work.agent] = chain_hash(chain_hash(work.agent, frame_), agent_hashes_[work.agent]);
  }
  std::uint64_t sum = 0;
  for (const std::uint64_t hash : agent_hashes_) sum += hash;
  pose_hash_ = chain_hash(pose_hash_, sum);
}

}  // namespace throng::anim
