#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "throng/ids.h"

#include "engine/anim/agent/character_agents.h"

namespace throng::anim {

// The reasons why a call with such an id is refused.
inline constexpr const char* no_agent = "an agent of this id is not in the system";
inline constexpr const char* no_character = "a character of this id is not in the system";

/// The character of an agent, and its number among the agents of that character.
struct Member {
  static constexpr std::uint32_t dead = 1U << 31;  ///< set in the generation of a number that no agent has

  std::uint32_t character;
  std::uint32_t index;
  std::uint32_t generation;  ///< of the agent that has this number, or of its next owner

  bool alive() const { return (generation & dead) == 0; }
};

/// Agents in the order in which they were added, and the place of each number in it. Poses are hashed by the place, so
/// that a hash does not depend on dead agents.
struct AgentOrder {
  std::vector<AgentId> agents;        // [place]
  std::vector<std::uint32_t> places;  // [number] meaningless for the dead
  std::uint64_t version = 0;          // another one whenever a place belongs to another agent
};

/// The numbers of the agents of a population. The numbers of dead agents are used again, the last first.
class AgentNumbers {
 public:
  /// Returns how many agents live.
  std::uint32_t count() const { return static_cast<std::uint32_t>(members_.size() - free_.size()); }
  /// Returns a number above all agents' numbers.
  std::uint32_t number_limit() const { return static_cast<std::uint32_t>(members_.size()); }
  std::span<const Member> members() const { return members_; }
  const Member& member(std::uint32_t agent) const { return members_[agent]; }
  bool has(std::uint32_t agent) const { return agent < members_.size() && members_[agent].alive(); }
  bool has(AgentId agent) const {
    return has(agent.number) &&
           (agent.generation == whichever || agent.generation == members_[agent.number].generation);
  }
  AgentId id(std::uint32_t agent) const { return {agent, members_[agent].generation}; }
  /// Returns the living agents. They stay where they are until agents are added or removed.
  const AgentOrder& order();

  /// Makes room for so many more agents.
  void make_room(std::uint32_t agents);
  /// Gives a number to an agent.
  AgentId add(std::uint32_t character, std::uint32_t index);
  void remove(std::uint32_t agent);
  /// Takes the numbers of a snapshot, as another order.
  void restore(const AgentNumbers& from);

 private:
  std::vector<Member> members_;      // [agent]
  std::vector<std::uint32_t> free_;  // numbers of dead agents; the last is given next
  AgentOrder order_;
  bool some_in_order_died_ = false;
};

/// The state of a population at a moment.
struct PopulationSnapshot {
  std::vector<CharacterAgentsSnapshot> characters;
  std::vector<std::uint32_t> character_generations;  // whose pools the graphs of these characters point at
  AgentNumbers numbers;
  std::vector<Ticks> posed_at;
  Ticks clock{};
  Ticks shared_posed_at{};
  StreamKind stream = StreamKind::sampled;  // which the players read

  std::size_t bytes() const;
  /// Widens the demand to what these graphs ask of the local stores.
  void widen(LocalStoreDemand& demand) const;
};

/// The characters of a system, their agents in one numbering, the clock, and the time at which each agent stands.
class Population {
 public:
  /// Returns [character]. A free number holds a character without bones, agents and clips.
  std::span<const std::unique_ptr<CharacterAgents>> characters() const { return characters_; }
  /// Adds a character under the lowest free number. There must be fewer than most_skeletons.
  CharacterId add_character(std::shared_ptr<const Character> character);
  /// Removes a character that has no agents.
  void remove_character(std::uint32_t character);
  bool has(CharacterId character) const;
  bool has_room_for_character() const { return character_count() < most_skeletons; }
  std::size_t character_count() const;
  /// Returns an id of nothing if there is no such number.
  CharacterId id_of_character(std::uint32_t character) const {
    return character < characters_.size() ? CharacterId{character, character_generations_[character]} : CharacterId{};
  }
  /// Converts the blocks of all agents to the residency of a schedule, and their players to a stream.
  void convert(Residency residency, StreamKind stream);

  const AgentNumbers& numbers() const { return numbers_; }
  AgentNumbers& numbers() { return numbers_; }
  /// Adds an agent. make_room() makes this cheap for many agents.
  AgentId add(std::uint32_t character);
  /// Makes room for so many more agents of a character.
  void make_room(std::uint32_t agents, std::uint32_t character);
  void remove(std::uint32_t agent);

  CharacterAgents& character_of(std::uint32_t agent) { return *characters_[numbers_.member(agent).character]; }
  const CharacterAgents& character_of(std::uint32_t agent) const {
    return *characters_[numbers_.member(agent).character];
  }
  const PoseGraph& graph(std::uint32_t agent) const {
    return character_of(agent).agents.graph(numbers_.member(agent).index);
  }
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
  /// Checks that the snapshot is of this population. Errors: it is empty, or characters, their clips, their kinds of
  /// entities or the order of their bones differ.
  Status can_restore(const PopulationSnapshot& from) const;
  /// Puts a snapshot back. Players keep their present stream, whichever it was then.
  Status restore(const PopulationSnapshot& from);
  /// Returns the bytes of all living blocks, and of the lists of agents.
  std::size_t bytes() const;

 private:
  std::vector<std::unique_ptr<CharacterAgents>> characters_;
  std::vector<std::uint32_t> character_generations_;  // [character] of free numbers too
  AgentNumbers numbers_;
  std::vector<Ticks> posed_at_;  // [agent] the time at which its entities stand
  Ticks clock_{};
  Ticks shared_posed_at_{};
  StreamKind stream_ = StreamKind::sampled;  // the stream of new players
  Residency residency_ = Residency::transient;
};

}  // namespace throng::anim
