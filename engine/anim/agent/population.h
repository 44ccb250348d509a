#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/anim/agent/character_agents.h"

namespace throng::anim {

/// The character of an agent, and its number among the agents of that character.
struct Member {
  std::uint32_t character;
  std::uint32_t index;
};

/// The state of a population at a moment.
struct PopulationSnapshot {
  std::vector<CharacterAgentsSnapshot> characters;
  std::vector<Member> members;
  std::vector<Ticks> posed_at;
  Ticks clock{};
  Ticks shared_posed_at{};

  std::size_t bytes() const;
  /// Widens the demand to what these graphs ask of the local stores.
  void widen(LocalStoreDemand& demand) const;
};

/// The characters of a system, their agents in one numbering, the clock, and the time at which each agent stands.
class Population {
 public:
  std::span<const std::unique_ptr<CharacterAgents>> characters() const { return characters_; }
  void add_character(std::shared_ptr<const Character> character);
  void remove_last_character() { characters_.pop_back(); }
  /// Converts the blocks of all agents to the residency of a schedule, and their players to a stream.
  void convert(Residency residency, StreamKind stream);

  std::uint32_t count() const { return static_cast<std::uint32_t>(members_.size()); }
  std::span<const Member> members() const { return members_; }
  const Member& member(std::uint32_t agent) const { return members_[agent]; }
  /// Does what AnimationSystem::set_agent_count does.
  void resize(std::uint32_t agents);
  /// Does what AnimationSystem::add_agents does.
  std::uint32_t add(std::uint32_t agents, std::uint32_t character);
  std::uint32_t add(std::span<const std::uint8_t> characters);

  CharacterAgents& character_of(std::uint32_t agent) { return *characters_[members_[agent].character]; }
  const CharacterAgents& character_of(std::uint32_t agent) const { return *characters_[members_[agent].character]; }
  const PoseGraph& graph(std::uint32_t agent) const { return character_of(agent).agents.graph(members_[agent].index); }
  /// Returns a builder of entities that stand at the time of the agent.
  EntityBuilder builder(std::uint32_t agent);
  /// Returns a builder of entities of a shared graph of this character.
  EntityBuilder shared_builder(CharacterAgents& character, std::uint32_t graph) const;

  Ticks clock() const { return clock_; }
  void advance(Ticks delta) { clock_ += delta; }
  Ticks posed_at(std::uint32_t agent) const { return posed_at_[agent]; }
  std::span<Ticks> posed_at() { return posed_at_; }
  Ticks shared_posed_at() const { return shared_posed_at_; }
  void shared_are_posed() { shared_posed_at_ = clock_; }
  /// Begins the clock anew. There must be no agents.
  void restart();

  void snapshot(PopulationSnapshot& into) const;
  /// Checks that the snapshot is of this population. Errors: it is empty, or characters, their kinds of entities or the
  /// order of their bones differ.
  Status can_restore(const PopulationSnapshot& from) const;
  Status restore(const PopulationSnapshot& from);
  Compaction compact();
  /// Returns the bytes of all blocks that live, and of what is kept for each agent.
  std::size_t bytes() const;

 private:
  void make_agents(std::uint32_t first);

  std::vector<std::unique_ptr<CharacterAgents>> characters_;
  std::vector<Member> members_;  // [agent]
  std::vector<Ticks> posed_at_;  // [agent] the time at which its entities stand
  Ticks clock_{};
  Ticks shared_posed_at_{};
  StreamKind stream_ = StreamKind::sampled;  // the stream of new players
};

}  // namespace throng::anim
