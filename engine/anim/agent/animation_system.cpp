#include "engine/anim/agent/animation_system.h"

#include <algorithm>
#include <utility>

#include "engine/anim/base/zone.h"

namespace throng::anim {
namespace {

constexpr Ticks latest_clock = std::int64_t{36525} * 24 * 3600 * ticks_per_second;  // a hundred years

}  // namespace

Result<std::unique_ptr<AnimationSystem>> AnimationSystem::create(std::shared_ptr<const Character> character,
                                                                 const SystemOptions& options) {
  constexpr const char* call = "AnimationSystem::create";
  if (character == nullptr) return refuse({call, "the character is null"});
  if (const char* fault = fault_of(*character); fault != nullptr) return refuse({call, fault});
  std::unique_ptr<AnimationSystem> system(new AnimationSystem());
  system->parts_.population.add_character(std::move(character));
  const Status configured = system->configure(options);
  if (!configured) return configured.error();
  return system;
}

AnimationSystem::~AnimationSystem() {
  if (parts_.turn.load())
    report_misuse({"~AnimationSystem", "the system is in the middle of a call on another thread"});
}

Status AnimationSystem::configure(const SystemOptions& options) {
  const Turn turn(parts_.turn, "Crowd::configure");
  if (!turn) return Turn::refusal();
  return parts_.pus.configure(parts_.population, options);
}

bool AnimationSystem::add(std::uint32_t count, CharacterId character, const Turn& turn) {
  Population& population = parts_.population;
  if (!population.has(character)) return turn.report(no_character);
  if (count > most_agents - std::min(agent_count(), most_agents)) {
    return turn.report("a system has at most 1,048,576 agents");
  }
  population.make_room(count, character.number);
  for (std::uint32_t i = 0; i < count; ++i) population.add(character.number);
  return true;
}

// Once a call, however many characters its agents are of.
void AnimationSystem::make_room() {
  parts_.frame.reserve(number_limit());
  parts_.pus.reserve(parts_.population);
}

AgentId AnimationSystem::add_agent(CharacterId character) {
  const std::span<const AgentId> added = add_agents(1, character);
  return added.empty() ? AgentId{} : added.front();
}

std::span<const AgentId> AnimationSystem::add_agents(std::uint32_t count, CharacterId character) {
  const Turn turn(parts_.turn, "Crowd::add_agents");
  if (!turn || !add(count, character, turn)) return {};
  make_room();
  return agents().last(count);
}

std::span<const AgentId> AnimationSystem::add_agents(std::span<const std::uint8_t> characters) {
  const Turn turn(parts_.turn, "Crowd::add_agents");
  if (!turn) return {};
  std::size_t done = 0;
  while (done < characters.size()) {
    const auto alike =
        std::ranges::find_if(characters.subspan(done), [&](auto other) { return other != characters[done]; });
    const auto count = static_cast<std::size_t>(alike - (characters.begin() + static_cast<std::ptrdiff_t>(done)));
    if (!add(static_cast<std::uint32_t>(count), parts_.population.id_of_character(characters[done]), turn)) break;
    done += count;
  }
  make_room();
  return agents().last(done);
}

bool AnimationSystem::remove_agent(AgentId agent) {
  const Turn turn(parts_.turn, "Crowd::remove_agent");
  if (!turn) return false;
  if (!parts_.population.numbers().has(agent)) return turn.report(no_agent);
  parts_.population.remove(agent.number);
  parts_.frame.forget_agent(agent.number);
  return true;
}

bool AnimationSystem::set_agent_count(std::uint32_t count) {
  const Turn turn(parts_.turn, "AnimationSystem::set_agent_count");
  if (!turn) return false;
  while (agent_count() > count) {
    const AgentId last = agents().back();
    parts_.population.remove(last.number);
    parts_.frame.forget_agent(last.number);
  }
  const bool added = agent_count() == count || add(count - agent_count(), parts_.population.id_of_character(0), turn);
  make_room();
  return added;
}

AgentId AnimationSystem::id(std::uint32_t number) const {
  return parts_.population.numbers().has(number) ? parts_.population.numbers().id(number) : AgentId{};
}

// In a child of fork() PUs cannot run before the system is configured there, unless a host runs them or there is but
// one.
bool AnimationSystem::can_run(const Turn& turn) const {
  const char* const fault = parts_.pus.fault();
  return fault == nullptr || turn.report(fault);
}

void AnimationSystem::advance(Ticks delta) {
  const Zone zone("Crowd::advance", 0);
  const Turn turn(parts_.turn, "Crowd::advance");
  if (!turn) return;
  if (delta < Ticks{0}) {
    turn.report("time does not go back");
  } else if (delta > latest_clock - clock()) {
    turn.report("the clock ends after a hundred years");
  } else {
    parts_.population.advance(delta);
  }
}

void AnimationSystem::update(std::span<const PoseRequest> agents) {
  const Zone zone("Crowd::update", 0);
  const Turn turn(parts_.turn, "Crowd::update");
  if (turn && can_run(turn)) parts_.frame.update(parts_.population, parts_.pus, agents);
}

void AnimationSystem::pose_exactly(std::span<const ExactPose> agents) {
  const Zone zone("Crowd::pose_exactly", 0);
  const Turn turn(parts_.turn, "Crowd::pose_exactly");
  if (turn && can_run(turn)) parts_.exact.pose(parts_.population, parts_.pus, agents);
}

bool AnimationSystem::restart() {
  const Turn turn(parts_.turn, "AnimationSystem::restart");
  if (!turn) return false;
  if (agent_count() > 0) return turn.report("agents stand at times of the old clock: remove them first");
  parts_.population.restart();
  parts_.frame.restart();
  return true;
}

}  // namespace throng::anim
