#include "engine/anim/agent/frame_work.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <new>

#include "engine/anim/agent/wind_back.h"
#include "engine/anim/base/misuse.h"
#include "engine/anim/base/room.h"
#include "engine/anim/run/program/stream_reads.h"
#include "engine/base/hash.h"

namespace throng::anim {
namespace {

constexpr std::size_t agents_ahead = 12;  // that the caches are asked for while one is listed
constexpr Ticks farthest_ahead = 3600 * ticks_per_second;

/// The facts that follow from an agent's program and level, which the agent before nearly always shares.
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

/// Asks the caches for an agent that will be listed soon: due agents lie far apart.
THRONG_ALWAYS_INLINE void prefetch_graph(const Population& population, std::uint32_t agent) {
  const std::span<const Member> members = population.numbers().members();
  if (agent >= members.size() || !members[agent].alive()) return;
  prefetch_agent(population.characters()[members[agent].character]->agents, members[agent].index);
}

/// Updates the shared channels of a character that are due; true: there were some.
bool update_shared(const Population& population, CharacterAgents& character) {
  bool changed = false;
  AgentGraphs& shared = character.shared;
  for (std::uint32_t graph = 0; graph < shared.count(); ++graph) {
    if (shared.next_update(graph) > population.clock()) continue;
    [[maybe_unused]] const Handle root = shared.graph(graph).root();
    const EntityBuilder build = population.shared_builder(character, graph);
    [[maybe_unused]] const Status updated = shared.update(build, graph) ? Status(Done{}) : shared.rebuild(build, graph);
    assert(updated && shared.graph(graph).root() == root && "a shared channel changed to another state");
    changed = true;
  }
  if (changed) shared.recompile();  // later graphs may read earlier ones, whose depth may have changed
  return changed;
}

}  // namespace

void FrameWork::update(Population& population, FittedScheduler& pus, std::span<const PoseRequest> agents) {
  ++hashes_.frame;
  report_ = {};
  list_shared_work(population, pus);
  list_work(population, pus, agents);
  const bool hash = pus.options().hash;
  pus.set_hashes(hash ? std::span(hashes_.palettes) : std::span(hashes_.palettes).first(0));
  pus.set_joints(joints_to_);
  pus.scheduler().update(pus.contexts(), shared_work_, {work_, runs_}, pus.executor());
  report_work(population, pus);
  if (hash) sum_up_hashes(population.numbers().order());
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
      if (shared.graph(graph).empty()) continue;
      shared_work_.push_back({.program = shared.graph(graph).program,
                              .entities = shared.graph(graph).entities.data(),
                              .delta = population.clock() - population.shared_posed_at(),
                              .agent = shared_owner | graph,
                              .skeleton = static_cast<std::uint8_t>(character)});
    }
  }
  population.shared_are_posed();
}

void FrameWork::list_work(Population& population, FittedScheduler& pus, std::span<const PoseRequest> agents) {
  work_.resize(agents.size());
  // Nothing below moves these, and the compiler cannot know.
  const std::span<const Member> members = population.numbers().members();
  const std::span<const std::unique_ptr<CharacterAgents>> characters = population.characters();
  const std::span<Ticks> posed_at = population.posed_at();
  const Ticks now = population.clock();
  AlikeAgents alike;
  AgentWork* work = work_.data();
  const auto listed = [&] { return static_cast<std::uint32_t>(work - work_.data()); };
  const auto end_run = [&] {
    if (!runs_.empty()) runs_.back().count = listed() - runs_.back().first;
  };
  const bool lists_joints =
      std::ranges::any_of(pus.contexts(), [](const UpdateContext& one) { return !one.joint_programs.empty(); });
  runs_.clear();
  for (std::size_t place = 0; place < agents.size(); ++place) {
    if (place + 2 * agents_ahead < agents.size()) {
      const std::uint32_t agent = agents[place + 2 * agents_ahead].agent.number;
      prefetch(members.data() + agent);
      prefetch_to_write(posed_at.data() + agent);
      prefetch_to_write(hashes_.frames.data() + agent);
      prefetch_graph(population, agents[place + agents_ahead].agent.number);
    }
    const PoseRequest& update = agents[place];
    if (!may_update(population, pus.contexts(), update)) [[unlikely]]
      continue;
    const std::uint32_t agent = update.agent.number;
    const Member member = members[agent];
    const AgentGraphs& graphs = characters[member.character]->agents;
    if (graphs.next_update(member.index) <= now) [[unlikely]] {
      [[maybe_unused]] const Status updated = pus.update_channels(population, agent);
      assert(updated && "a channel changed by itself to a graph that cannot be run");
    }
    const PoseGraph& graph = graphs.graph(member.index);
    if (graph.empty()) [[unlikely]] {
      report_misuse({"Crowd::update", "an agent plays something before it is updated"});
      continue;
    }
    if (!alike.include(*graph.program, update.level)) [[unlikely]] {
      const PoseProgram& program = *graph.program;
      end_run();
      runs_.push_back({.first = listed()});
      alike = {.program = &program,
               .level = update.level,
               .cost = pus.predicted_cost(program, member.character, update.level),
               .held = program.needs.held,
               .look_ahead = program.needs.shared == 0};
    }
    Ticks time = alike.look_ahead ? now + update.look_ahead : now;
    const Ticks before = posed_at[agent];
    if (time < before && !can_wind_back(population, agent)) [[unlikely]]
      time = before;
    posed_at[agent] = time;
    hashes_.frames[agent] = hashes_.frame;
    if (lists_joints) joints_to_[agent] = update.joints;
    ::new (work++) AgentWork{.program = alike.program,
                             .entities = graph.entities.data(),
                             .delta = time - before,
                             .palette = update.palette,
                             .agent = agent,
                             .cost = alike.cost,
                             .skeleton = static_cast<std::uint8_t>(member.character),
                             .level = update.level,
                             .fade_level = update.fade_level,
                             .fade_halves = update.fade_halves,
                             .held = alike.held};
  }
  end_run();
  work_.resize(listed());
}

// Checks the values that the host wrote, before anything of the agent changes.
bool FrameWork::may_update(const Population& population, std::span<const UpdateContext> contexts,
                           const PoseRequest& update) const {
  const auto refused = [](const char* reason) { return report_misuse({"Crowd::update", reason}); };
  if (!population.numbers().has(update.agent)) return refused(no_agent);
  const std::uint32_t character = population.numbers().member(update.agent.number).character;
  const std::size_t levels = contexts[character].level_bone_counts.size();
  if (update.level >= levels) return refused("the agent's character has fewer bone levels");
  if (update.fade_halves > 2 || (update.fade_halves > 0 && update.fade_level >= levels)) {
    return refused("a pose fades by 0 to 2 halves to a bone level of its character");
  }
  if (update.look_ahead < Ticks{} || update.look_ahead > farthest_ahead)
    return refused("a pose looks 0 to an hour ahead");
  if (PaletteDestination(update.palette).is_misaligned()) return refused("a palette lies at a multiple of 16 bytes");
  if (PaletteDestination(update.joints).is_misaligned()) return refused("joints lie at a multiple of 16 bytes");
  if (update.joints != nullptr && contexts[character].joint_programs.empty()) {
    return refused("the agent's character lists no joints: call Crowd::write_joints first");
  }
  if (hashes_.frames[update.agent.number] == hashes_.frame) return refused("an agent is updated once in a call");
  return true;
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

// The place of an agent is its number in a run that never had the dead agents.
void FrameWork::hash_agent(std::uint32_t agent, std::uint32_t place) {
  const std::uint64_t frame = hashes_.frames[agent];
  hashes_.agents[agent] = frame == 0 ? 0 : chain_hash(chain_hash(place, frame), hashes_.palettes[agent]);
}

void FrameWork::sum_up_hashes(const AgentOrder& order) {
  for (const AgentWork& work : work_) hash_agent(work.agent, order.places[work.agent]);
  if (hashes_.order != order.version) {
    hashes_.order = order.version;
    for (std::uint32_t place = 0; const AgentId agent : order.agents) hash_agent(agent.number, place++);
  }
  std::uint64_t sum = 0;
  for (const AgentId agent : order.agents) sum += hashes_.agents[agent.number];
  hashes_.poses = chain_hash(hashes_.poses, sum);
}

void FrameWork::reserve(std::uint32_t limit) {
  if (limit <= hashes_.agents.size()) return;
  make_room(work_, limit);
  make_room(runs_, limit);
  hashes_.agents.resize(limit, 0);
  hashes_.palettes.resize(limit, 0);
  hashes_.frames.resize(limit, 0);
  joints_to_.resize(limit);
}

void FrameWork::forget_agent(std::uint32_t agent) {
  hashes_.agents[agent] = 0;
  hashes_.palettes[agent] = 0;
  hashes_.frames[agent] = 0;
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
