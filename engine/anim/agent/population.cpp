#include "engine/anim/agent/population.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/anim/base/room.h"

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

CharacterId Population::add_character(std::shared_ptr<const Character> character) {
  const auto free =
      std::ranges::find_if(characters_, [](const auto& one) { return one->character == no_agents().character; });
  const auto number = static_cast<std::uint32_t>(free - characters_.begin());
  if (free == characters_.end()) {
    characters_.emplace_back();
    character_generations_.resize(std::max(character_generations_.size(), characters_.size()), 0);
  }
  characters_[number] = std::make_unique<CharacterAgents>(std::move(character));
  characters_[number]->set_residency(residency_);
  return id_of_character(number);
}

std::size_t Population::character_count() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(characters_, [](const auto& one) { return one->character != no_agents().character; }));
}

void Population::remove_character(std::uint32_t character) {
  assert(characters_[character]->agents.alive_count() == 0 && "its agents play it");
  characters_[character] = std::make_unique<CharacterAgents>(no_agents().character);
  ++character_generations_[character];
  while (characters_.back()->character == no_agents().character) characters_.pop_back();
}

bool Population::has(CharacterId character) const {
  return character.number < characters_.size() && characters_[character.number]->character != no_agents().character &&
         (character.generation == whichever || character.generation == character_generations_[character.number]);
}

void Population::convert(Residency residency, StreamKind stream) {
  stream_ = stream;
  residency_ = residency;
  for (const std::unique_ptr<CharacterAgents>& character : characters_) {
    character->set_residency(residency);
    character->set_stream(stream);
  }
}

void AgentNumbers::make_room(std::uint32_t agents) {
  const std::size_t fresh = agents > free_.size() ? agents - free_.size() : 0;
  anim::make_room(members_, members_.size() + fresh);
  anim::make_room(order_.agents, order_.agents.size() + agents);
  anim::make_room(order_.places, order_.places.size() + fresh);
  free_.reserve(members_.capacity());
}

AgentId AgentNumbers::add(std::uint32_t character, std::uint32_t index) {
  order();  // dead agents have left the order, since a number may come back at another place
  if (free_.empty()) {
    free_.push_back(number_limit());
    members_.push_back({.character = 0, .index = 0, .generation = Member::dead});
    order_.places.push_back(0);
  }
  const std::uint32_t number = free_.back();
  free_.pop_back();
  Member& member = members_[number];
  member = {.character = character, .index = index, .generation = member.generation & ~Member::dead};
  order_.places[number] = static_cast<std::uint32_t>(order_.agents.size());
  order_.agents.push_back(id(number));
  return id(number);
}

void AgentNumbers::remove(std::uint32_t agent) {
  Member& member = members_[agent];
  member.generation = (member.generation + 1) | Member::dead;
  free_.push_back(agent);
  if (!some_in_order_died_ && order_.agents.back().number == agent) {
    order_.agents.pop_back();
  } else {
    some_in_order_died_ = true;
  }
}

const AgentOrder& AgentNumbers::order() {
  if (!some_in_order_died_) return order_;
  some_in_order_died_ = false;
  std::erase_if(order_.agents, [&](AgentId agent) { return !has(agent); });
  for (std::uint32_t place = 0; const AgentId agent : order_.agents) order_.places[agent.number] = place++;
  ++order_.version;
  return order_;
}

void AgentNumbers::restore(const AgentNumbers& from) {
  const std::uint64_t version = order_.version + 1;
  *this = from;
  order_.version = version;
}

void Population::make_room(std::uint32_t agents, std::uint32_t character) {
  CharacterAgents& played = *characters_[character];
  played.reserve_fades(stream_, std::size_t{played.agents.alive_count()} + agents);
  played.agents.make_room(agents);
  numbers_.make_room(agents);
  anim::make_room(posed_at_, std::size_t{numbers_.number_limit()} + agents);
}

AgentId Population::add(std::uint32_t character) {
  const AgentId agent = numbers_.add(character, characters_[character]->agents.add());
  if (agent.number == posed_at_.size()) posed_at_.emplace_back();
  posed_at_[agent.number] = clock_;
  return agent;
}

void Population::remove(std::uint32_t agent) {
  const Member& member = numbers_.member(agent);
  characters_[member.character]->agents.remove(member.index);
  numbers_.remove(agent);
}

EntityBuilder Population::builder(std::uint32_t agent) {
  CharacterAgents& character = character_of(agent);
  return {character.pools,
          character.clips,
          {.owner = numbers_.member(agent).index,
           .now = clock_,
           .posed_at = posed_at_[agent],
           .stream = stream_,
           .masks = character.masks.size(),
           .selections = character.selections.size()}};
}

EntityBuilder Population::shared_builder(CharacterAgents& character, std::uint32_t graph) const {
  return {character.pools,
          character.clips,
          {.owner = shared_owner | graph,
           .now = clock_,
           .posed_at = shared_posed_at_,
           .stream = stream_,
           .masks = character.masks.size(),
           .selections = character.selections.size()}};
}

void Population::restart() {
  assert(numbers_.count() == 0 && "agents stand at times of the old clock");
  clock_ = Ticks{};
  shared_posed_at_ = Ticks{};
}

void Population::snapshot(PopulationSnapshot& into) const {
  into.characters.resize(characters_.size());
  for (std::size_t i = 0; i < characters_.size(); ++i) characters_[i]->snapshot(into.characters[i]);
  into.character_generations = character_generations_;
  into.numbers = numbers_;
  into.posed_at = posed_at_;
  into.clock = clock_;
  into.shared_posed_at = shared_posed_at_;
  into.stream = stream_;
}

Status Population::can_restore(const PopulationSnapshot& from) const {
  if (from.characters.empty()) return Error{"there is no crowd in this snapshot: take one first"};
  if (from.characters.size() != characters_.size() || from.character_generations != character_generations_) {
    return Error{"characters came or went since this snapshot: take another one"};
  }
  for (std::size_t i = 0; i < characters_.size(); ++i) {
    if (from.characters[i].pools.size() != std::size_t{2} * characters_[i]->pools.kind_count()) {
      return Error{"kinds of entities were added since this snapshot: take another one"};
    }
    if (from.characters[i].character != characters_[i]->character) {
      return Error{"\"" + characters_[i]->skeleton().name +
                   "\" has other clips, or its bones in another order, since this snapshot: take another one"};
    }
  }
  return Done{};
}

Status Population::restore(const PopulationSnapshot& from) {
  for (std::size_t i = 0; i < characters_.size(); ++i) {
    if (Status restored = characters_[i]->restore(from.characters[i]); !restored) return restored;
  }
  numbers_.restore(from.numbers);
  posed_at_ = from.posed_at;
  clock_ = from.clock;
  shared_posed_at_ = from.shared_posed_at;
  if (from.stream != stream_) convert(residency_, stream_);
  return Done{};
}

std::size_t Population::bytes() const {
  std::size_t bytes = numbers_.count() * (sizeof(Member) + sizeof(Ticks));
  for (const std::unique_ptr<CharacterAgents>& character : characters_) bytes += character->bytes_alive();
  return bytes;
}

}  // namespace throng::anim
