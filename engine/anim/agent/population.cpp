#include "engine/anim/agent/population.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace throng::anim {

std::size_t PopulationSnapshot::bytes() const {
  std::size_t bytes = posed_at.size() * sizeof(Ticks);
  for (const CharacterAgentsSnapshot& character : characters) bytes += character.bytes();
  return bytes;
}

void PopulationSnapshot::widen(LocalStoreDemand& demand) const {
  for (const CharacterAgentsSnapshot& character : characters) {
    demand.largest.widen(character.agents->largest_needs());
    demand.shared_entity_bytes =
        std::max<std::size_t>(demand.shared_entity_bytes, character.shared->largest_needs().entity_bytes);
  }
}

void Population::add_character(std::shared_ptr<const Character> character) {
  characters_.push_back(std::make_unique<CharacterAgents>(std::move(character)));
}

void Population::convert(Residency residency, StreamKind stream) {
  stream_ = stream;
  for (const std::unique_ptr<CharacterAgents>& character : characters_) {
    character->set_residency(residency);
    character->set_stream(stream);
  }
}

void Population::resize(std::uint32_t agents) {
  if (agents == 0) {
    for (const std::unique_ptr<CharacterAgents>& character : characters_) character->agents.resize(0);
  } else {
    assert(characters_.front()->agents.count() == count() && "agents of several characters: use add_agents");
    characters_.front()->reserve_fades(stream_, agents);
    characters_.front()->agents.resize(agents);
  }
  for (std::uint32_t agent = count(); agent < agents; ++agent) members_.push_back({.character = 0, .index = agent});
  members_.resize(agents);
  posed_at_.resize(agents, clock_);
}

std::uint32_t Population::add(std::uint32_t agents, std::uint32_t character) {
  const std::uint32_t first = count();
  const std::uint32_t next = characters_[character]->agents.count();
  for (std::uint32_t i = 0; i < agents; ++i) members_.push_back({.character = character, .index = next + i});
  make_agents(first);
  return first;
}

std::uint32_t Population::add(std::span<const std::uint8_t> characters) {
  const std::uint32_t first = count();
  std::array<std::uint32_t, most_skeletons> next{};
  for (std::size_t i = 0; i < characters_.size(); ++i) next[i] = characters_[i]->agents.count();
  members_.reserve(first + characters.size());
  for (const std::uint8_t character : characters) {
    members_.push_back({.character = character, .index = next[character]++});
  }
  make_agents(first);
  return first;
}

// For the members from `first` on, those of one character all at once.
void Population::make_agents(std::uint32_t first) {
  std::array<std::uint32_t, most_skeletons> added{};
  for (const Member& member : std::span(members_).subspan(first)) ++added[member.character];
  for (std::size_t i = 0; i < characters_.size(); ++i) {
    if (added[i] == 0) continue;
    const std::uint32_t all = characters_[i]->agents.count() + added[i];
    characters_[i]->reserve_fades(stream_, all);
    characters_[i]->agents.resize(all);
  }
  posed_at_.resize(count(), clock_);
}

EntityBuilder Population::builder(std::uint32_t agent) {
  CharacterAgents& character = character_of(agent);
  return {character.pools,
          character.clips,
          {.owner = members_[agent].index, .now = clock_, .posed_at = posed_at_[agent], .stream = stream_}};
}

EntityBuilder Population::shared_builder(CharacterAgents& character, std::uint32_t graph) const {
  return {character.pools,
          character.clips,
          {.owner = shared_owner | graph, .now = clock_, .posed_at = shared_posed_at_, .stream = stream_}};
}

void Population::restart() {
  assert(count() == 0 && "agents stand at times of the old clock");
  clock_ = Ticks{};
  shared_posed_at_ = Ticks{};
}

void Population::snapshot(PopulationSnapshot& into) const {
  into.characters.resize(characters_.size());
  for (std::size_t i = 0; i < characters_.size(); ++i) characters_[i]->snapshot(into.characters[i]);
  into.members = members_;
  into.posed_at = posed_at_;
  into.clock = clock_;
  into.shared_posed_at = shared_posed_at_;
}

Status Population::can_restore(const PopulationSnapshot& from) const {
  if (from.characters.empty()) return Error{"there is no crowd in this snapshot: take one first"};
  if (from.characters.size() != characters_.size()) {
    return Error{"characters were added since this snapshot: take another one"};
  }
  for (std::size_t i = 0; i < characters_.size(); ++i) {
    if (from.characters[i].pools.size() != std::size_t{2} * characters_[i]->pools.kind_count()) {
      return Error{"kinds of entities were added since this snapshot: take another one"};
    }
    if (from.characters[i].character != characters_[i]->character) {
      return Error{"the bones of \"" + characters_[i]->skeleton().name +
                   "\" are in another order since this snapshot: take another one"};
    }
  }
  return Done{};
}

Status Population::restore(const PopulationSnapshot& from) {
  for (std::size_t i = 0; i < characters_.size(); ++i) {
    if (Status restored = characters_[i]->restore(from.characters[i]); !restored) return restored;
  }
  members_ = from.members;
  posed_at_ = from.posed_at;
  clock_ = from.clock;
  shared_posed_at_ = from.shared_posed_at;
  return Done{};
}

Compaction Population::compact() {
  Compaction all{.complete = true};
  for (const std::unique_ptr<CharacterAgents>& character : characters_) {
    const Compaction one = character->compact();
    all.blocks_moved += one.blocks_moved;
    all.bytes_given_back += one.bytes_given_back;
  }
  return all;
}

std::size_t Population::bytes() const {
  std::size_t bytes = count() * (sizeof(Member) + sizeof(Ticks));
  for (const std::unique_ptr<CharacterAgents>& character : characters_) bytes += character->bytes_alive();
  return bytes;
}

}  // namespace throng::anim
