#include "engine/anim/agent/frame_work.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <new>

#include "engine/anim/agent/wind_back.h"
#include "engine/anim/base/hash.h"
#include "engine/anim/run/program/stream_reads.h"

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

void update_channels(Population& population, FittedScheduler& pus, std::uint32_t agent) {
  [[maybe_unused]] const Status updated = pus.settle(population, agent, [&] {
    return population.character_of(agent).agents.update(population.builder(agent), population.member(agent).index);
  });
  assert(updated && "a channel changed by itself to a graph that cannot be run");
}

/// Updates the shared channels of a character that are due; true: there were some.
bool update_shared(const Population& population, CharacterAgents& character) {
  bool changed = false;
  AgentGraphs& shared = character.shared;
  for (std::uint32_t graph = 0; graph < shared.count(); ++graph) {
    if (shared.next_update(graph) > population.clock()) continue;
    [[maybe_unused]] const Handle root = shared.graph(graph).root();
    [[maybe_unused]] const Status updated = shared.update(population.shared_builder(character, graph), graph);
    assert(updated && shared.graph(graph).root() == root && "a shared channel changed to another state");
    changed = true;
  }
  if (changed) shared.recompile();  // later graphs may read earlier ones, whose depth may have changed
  return changed;
}

}  // namespace

void FrameWork::update(Population& population, FittedScheduler& pus, std::span<const AgentUpdate> agents) {
  ++hashes_.frame;
  report_ = {};
  list_shared_work(population, pus);
  list_work(population, pus, agents);
  const bool hash = pus.options().hash;
  pus.set_hashes(hash ? std::span(hashes_.agents) : std::span(hashes_.agents).first(0));
  pus.scheduler().update(pus.contexts(), shared_work_, {work_, runs_}, pus.executor());
  report_work(population, pus);
  if (hash) sum_up_hashes();
}

void FrameWork::list_shared_work(Population& population, FittedScheduler& pus) {
  shared_work_.clear();
  bool changed = false;
  for (const std::unique_ptr<CharacterAgents>& character : population.characters()) {
    changed = update_shared(population, *character) || changed;
  }
  [[maybe_unused]] const Status fits = changed ? pus.fit(population, pus.demand(population)) : Status(Done{});
  assert(fits && "a shared channel changed by itself to a graph that cannot be run");
  for (std::size_t character = 0; character < population.characters().size(); ++character) {
    const AgentGraphs& shared = population.characters()[character]->shared;
    for (std::uint32_t graph = 0; graph < shared.count(); ++graph) {
      shared_work_.push_back({.program = shared.graph(graph).program,
                              .entities = shared.graph(graph).entities.data(),
                              .delta = population.clock() - population.shared_posed_at(),
                              .agent = shared_owner | graph,
                              .skeleton = static_cast<std::uint8_t>(character)});
    }
  }
  population.shared_are_posed();
}

void FrameWork::list_work(Population& population, FittedScheduler& pus, std::span<const AgentUpdate> agents) {
  work_.resize(agents.size());
  // Nothing below moves these, and the compiler cannot know.
  const std::span<const Member> members = population.members();
  const std::span<const std::unique_ptr<CharacterAgents>> characters = population.characters();
  const std::span<Ticks> posed_at = population.posed_at();
  const Ticks now = population.clock();
  AlikeAgents alike;
  AgentWork* work = work_.data();
  const auto listed = [&] { return static_cast<std::uint32_t>(work - work_.data()); };
  const auto end_run = [&] {
    if (!runs_.empty()) runs_.back().count = listed() - runs_.back().first;
  };
  runs_.clear();
  for (const AgentUpdate& update : agents) {
    const Member member = members[update.agent];
    const AgentGraphs& graphs = characters[member.character]->agents;
    if (graphs.next_update(member.index) <= now) [[unlikely]]
      update_channels(population, pus, update.agent);
    const PoseGraph& graph = graphs.graph(member.index);
    assert(update.level < max_bone_levels && update.fade_level < max_bone_levels && update.fade_halves <= 2);
    assert(!graph.program->steps.empty() && "an agent must play something before it is updated");
    if (!alike.include(*graph.program, update.level)) [[unlikely]] {
      end_run();
      runs_.push_back({.first = listed()});
      const PoseProgram& program = *graph.program;
      alike = {.program = &program,
               .level = update.level,
               .cost = pus.predicted_cost(program, member.character, update.level),
               .held = program.needs.held,
               .look_ahead = program.needs.shared == 0};
    }
    Ticks time = alike.look_ahead ? now + update.look_ahead : now;
    const Ticks before = posed_at[update.agent];
    if (time < before && !can_wind_back(population, update.agent)) [[unlikely]]
      time = before;
    posed_at[update.agent] = time;
    ::new (work++) AgentWork{.program = alike.program,
                             .entities = graph.entities.data(),
                             .delta = time - before,
                             .palette = update.palette,
                             .agent = update.agent,
                             .cost = alike.cost,
                             .skeleton = static_cast<std::uint8_t>(member.character),
                             .level = update.level,
                             .fade_level = update.fade_level,
                             .fade_halves = update.fade_halves,
                             .held = alike.held};
  }
  end_run();
}

void FrameWork::report_work(const Population& population, const FittedScheduler& pus) {
  const WorkOrder& order = pus.scheduler().order();
  std::array<std::array<std::uint64_t, max_bone_levels>, most_skeletons> agents_by_level{};
  for (const WorkRun& run : order.runs()) {
    const AgentWork& like = order.work()[run.first];
    agents_by_level[like.skeleton][like.level] += run.count;
  }
  report_.predicted_nanoseconds = order.predicted();
  report_.agents_updated = static_cast<std::uint32_t>(order.work().size());
  for (std::size_t character = 0; character < population.characters().size(); ++character) {
    const Skeleton& skeleton = population.characters()[character]->skeleton();
    const std::size_t entry_bytes = palette_entry_bytes(pus.contexts()[character].palette_format);
    for (std::size_t level = 0; level < skeleton.level_bone_counts.size(); ++level) {
      const std::uint64_t count = agents_by_level[character][level];
      const int bones = skeleton.level_bone_counts[level];
      const auto entries = static_cast<std::uint64_t>(palette_count_for_bones(skeleton, bones));
      report_.bones_evaluated += count * static_cast<std::uint64_t>(bones);
      report_.palette_bytes += count * entries * entry_bytes;
      const auto width = static_cast<std::uint64_t>(widest_strip);  // whatever the store holds: budgets decide by this
      const std::uint64_t tiles = (count + width - 1) / width;
      report_.predicted_nanoseconds += static_cast<double>(tiles) * pus.options().cost.of_tile(packets_for(bones));
    }
  }
  for (const ProcessingUnit& unit : pus.scheduler().units()) report_.copies += unit.activity().copies;
}

void FrameWork::sum_up_hashes() {
  for (const AgentWork& work : work_) {
    std::uint64_t& hash = hashes_.agents[work.agent];
    hash = chain_hash(chain_hash(work.agent, hashes_.frame), hash);
  }
  std::uint64_t sum = 0;
  for (const std::uint64_t hash : hashes_.agents) sum += hash;
  hashes_.poses = chain_hash(hashes_.poses, sum);
}

void FrameWork::reserve(std::uint32_t agents) {
  hashes_.agents.resize(agents, 0);
  work_.reserve(agents);
  runs_.reserve(agents);
}

void FrameWork::restart() {
  hashes_.frame = 0;
  hashes_.poses = 0;
}

std::uint64_t FrameWork::stream_bytes(std::span<const UpdateContext> contexts) const {
  std::uint64_t bytes = 0;
  for (const std::span<const AgentWork> all : {std::span(shared_work_), std::span(work_)}) {
    for (const AgentWork& work : all) bytes += stream_bytes_read(contexts[work.skeleton], work);
  }
  return bytes;
}

}  // namespace throng::anim
