#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/anim/agent/character_agents.h"

namespace throng::anim {

/// Tells which character an agent is, and which number it has among the agents of that character.
struct Member {
  std::uint32_t character;
  std::uint32_t index;
};

/// A population as it was.
struct PopulationSnapshot {
  std::vector<CharacterAgentsSnapshot> characters;
  std::vector<Member> members;
  std::vector<Ticks> posed_at;
  Ticks clock = 0;
  Ticks shared_posed_at = 0;

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
  /// See AnimationSystem::set_agent_count.
  void resize(std::uint32_t agents);
  /// See AnimationSystem::add_agents.
  std::uint32_t add(std::uint32_t agents, std::uint32_t character);
  std::uint32_t add(std::span<const std::uint8_t> characters);

  CharacterAgents& character_of(std::uint32_t agent) { return *characters_[members_[agent].character]; }
  const CharacterAgents& character_of(std::uint32_t agent) const { return *characters_[members_[agent].character]; }
  const PoseGraph& graph(std::uint32_t agent) const { return character_of(agent).agents.graph(members_[agent].index); }
  /// Makes entities that stand at the time of the agent.
  EntityBuilder builder(std::uint32_t agent);
  /// Makes entities of a shared graph of this character.
  EntityBuilder shared_builder(CharacterAgents& character, std::uint32_t graph) const;

  Ticks clock() const { return clock_; }
  void advance(Ticks delta) { clock_ += delta; }
  Ticks posed_at(std::uint32_t agent) const { return posed_at_[agent]; }
  std::span<Ticks> posed_at() { return posed_at_; }
  Ticks shared_posed_at() const { return shared_posed_at_; }
  void shared_are_posed() { shared_posed_at_ = clock_; }
  /// The clock begins anew. There must be no agents.
  void restart();

  void snapshot(PopulationSnapshot& into) const;
  /// The error says why the snapshot is of another population: its characters or their kinds of entities differ.
  Status can_restore(const PopulationSnapshot& from) const;
  Status restore(const PopulationSnapshot& from);
  Compaction compact();
  /// The bytes of all blocks that live, and of what is kept for each agent.
  std::size_t bytes() const;

 private:
  void make_agents(std::uint32_t first);

  std::vector<std::unique_ptr<CharacterAgents>> characters_;
  std::vector<Member> members_;  // [agent]
  std::vector<Ticks> posed_at_;  // [agent] the time at which its entities stand
  Ticks clock_ = 0;
  Ticks shared_posed_at_ = 0;
  StreamKind stream_ = StreamKind::sampled;  // of new players
};

}  // namespace throng::anim
