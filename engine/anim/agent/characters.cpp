#include "engine/anim/agent/characters.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "engine/anim/bake/bone_match.h"

namespace throng::anim {
namespace {

const char* fault_of(const EntityKind& kind) {
  if (kind.advance == nullptr) return "a kind has the function advance";
  if ((kind.pose_packet != nullptr) == (kind.pose_whole != nullptr)) {
    return "a kind poses either packets (pose_packet) or whole poses (pose_whole)";
  }
  if (kind.prepared_bytes % 64 != 0 || kind.prepared_bytes > most_prepared_bytes) {
    return "prepared_bytes is a multiple of 64, and at most most_prepared_bytes";
  }
  return nullptr;
}

/// Checks that both are the same skeleton, with its bones in the same order.
Status has_bones_of(const Skeleton& skeleton, const Skeleton& other) {
  const Result<std::vector<int>> places = match_bones(skeleton, other);
  if (!places) return places.error();
  const bool is_in_order = std::ranges::is_sorted(*places) && skeleton.palette.size() == other.palette.size() &&
                           skeleton.level_bone_counts == other.level_bone_counts;
  if (is_in_order) return Done{};
  return Error{"\"" + other.name +
               "\" has its bones or its levels in another order: with_clips() of the character that "
               "agents play brings clips to its order"};
}

/// Tells whether each bone has a place of its own.
bool is_permutation_of_bones(std::span<const int> places, int bone_count) {
  std::vector<int> every_bone(static_cast<std::size_t>(bone_count));
  std::iota(every_bone.begin(), every_bone.end(), 0);
  std::vector<int> sorted(places.begin(), places.end());
  std::ranges::sort(sorted);
  return sorted == every_bone;
}

}  // namespace

const CharacterAgents& Characters::of(CharacterId character) const {
  return has(character) ? *system_->population.characters()[character.number] : no_agents();
}

PaletteFormat Characters::palette_format(CharacterId character) const {
  return has(character) ? system_->pus.contexts()[character.number].palette_format : PaletteFormat::matrices;
}

Status Characters::configure_again() { return system_->pus.configure(system_->population, system_->pus.options()); }

Result<CharacterId> Characters::add(std::shared_ptr<const Character> character) {
  const Turn turn(system_->turn, "Crowd::add");
  if (!turn) return Turn::refusal();
  if (character == nullptr) return turn.refuse("the character is null");
  if (const char* fault = fault_of(*character); fault != nullptr) return turn.refuse(fault);
  Population& population = system_->population;
  if (!population.has_room_for_character()) {
    return Error{"a system animates at most " + std::to_string(most_skeletons) +
                 " characters at a time: remove one that no agent plays, or use another system for \"" +
                 character->skeleton.name + "\""};
  }
  const CharacterId added = population.add_character(std::move(character));
  const Status fits = system_->pus.take_character(population, added.number);
  if (fits) return added;
  population.remove_character(added.number);
  system_->pus.refresh_contexts(population);
  return fits.error();
}

Status Characters::remove(CharacterId character) {
  const Turn turn(system_->turn, "Crowd::remove");
  if (!turn) return Turn::refusal();
  if (!has(character)) return turn.refuse(no_character);
  Population& population = system_->population;
  const CharacterAgents& agents = of(character);
  if (const std::uint32_t players = agents.agents.alive_count(); players > 0) {
    return Error{std::to_string(players) + " agents play \"" + agents.skeleton().name + "\": remove them first"};
  }
  if (population.character_count() == 1) {
    return Error{"\"" + agents.skeleton().name + "\" is the system's only character: add another one first"};
  }
  population.remove_character(character.number);
  system_->pus.refresh_contexts(population);
  return Done{};
}

Status Characters::replace(CharacterId character, std::shared_ptr<const Character> reordered,
                           std::span<const int> places) {
  const Turn turn(system_->turn, "Characters::replace");
  if (!turn) return Turn::refusal();
  if (!has(character)) return turn.refuse(no_character);
  CharacterAgents& agents = of(character);
  if (reordered == nullptr || reordered->skeleton.bone_count() != agents.skeleton().bone_count() ||
      !std::ranges::equal(reordered->clips, agents.character->clips, {}, &BakedClip::name, &BakedClip::name) ||
      !is_permutation_of_bones(places, agents.skeleton().bone_count())) {
    return turn.refuse("it is not the same character with its bones in another order");
  }
  const bool moves = !std::ranges::is_sorted(places);
  if (const std::string bound = agents.bound_to_bone_order(); moves && !bound.empty()) {
    return Error{"the bones of \"" + agents.skeleton().name + "\" keep their order: its agents have " + bound};
  }
  const std::shared_ptr<const Character> before = agents.replace_character(std::move(reordered));
  Status configured = configure_again();
  if (configured) {
    agents.reorder_bones(places);
    return configured;
  }
  agents.replace_character(before);
  system_->pus.refresh_contexts(system_->population);
  return configured;
}

Status Characters::replace_clips(CharacterId character, std::shared_ptr<const Character> other) {
  const Turn turn(system_->turn, "Crowd::replace");
  if (!turn) return Turn::refusal();
  if (!has(character)) return turn.refuse(no_character);
  if (other == nullptr) return turn.refuse("the character is null");
  if (const char* fault = fault_of(*other); fault != nullptr) return turn.refuse(fault);
  CharacterAgents& agents = of(character);
  if (Status same = has_bones_of(agents.skeleton(), other->skeleton); !same) return same;
  system_->pus.update_due_channels(system_->population, character.number);  // fades may be over
  if (std::string bound = agents.bound_to_clips(*other); !bound.empty()) return Error{std::move(bound)};
  const std::shared_ptr<const Character> before = agents.replace_clips(std::move(other));
  Status fits = system_->pus.take_character(system_->population, character.number);
  if (fits) return fits;
  agents.replace_clips(before);
  system_->pus.refresh_contexts(system_->population);
  return fits;
}

Status Characters::write_joints(const JointList& list, JointFormat format, CharacterId character) {
  const Turn turn(system_->turn, "Crowd::write_joints");
  if (!turn) return Turn::refusal();
  if (!has(character)) return turn.refuse(no_character);
  CharacterAgents& agents = of(character);
  std::vector<JointProgram> programs;
  for (const int bones : agents.skeleton().level_bone_counts) {
    if (list.empty()) break;
    Result<JointProgram> program = compile_joints(agents.skeleton(), list, format, bones);
    if (!program) return program.error();
    programs.push_back(std::move(*program));
  }
  agents.joint_programs.swap(programs);
  Status configured = configure_again();
  if (configured) return configured;
  agents.joint_programs.swap(programs);
  system_->pus.refresh_contexts(system_->population);
  return configured;
}

int Characters::add_mask(BoneMask mask, CharacterId character) {
  const Turn turn(system_->turn, "Crowd::add_mask");
  if (!turn) return PlayRequest::no_mask;
  const char* fault = nullptr;
  if (!has(character)) {
    fault = no_character;
  } else if (mask.packets() != packets_for(of(character).skeleton().bone_count())) {
    fault = "the mask was made for another skeleton";
  } else if (of(character).masks.size() == std::numeric_limits<std::int16_t>::max()) {
    fault = "a character has at most 32,767 masks";
  }
  if (fault != nullptr) {
    turn.report(fault);
    return PlayRequest::no_mask;
  }
  const int index = of(character).add_mask(std::move(mask));
  system_->pus.refresh_contexts(system_->population);
  return index;
}

std::uint32_t Characters::add_bone_selection(BoneSelection selection, CharacterId character) {
  const Turn turn(system_->turn, "Characters::add_bone_selection");
  if (!turn) return Player::every_bone;
  const bool fits = has(character) && selection.packets() == packets_for(of(character).skeleton().bone_count());
  if (!fits) {
    turn.report(has(character) ? "the selection was made for another skeleton" : no_character);
    return Player::every_bone;
  }
  const std::uint32_t index = of(character).add_selection(std::move(selection));
  system_->pus.refresh_contexts(system_->population);
  return index;
}

Result<EntityPools::Kind> Characters::add_entity_kind(const EntityKind& kind, CharacterId character, const char* call) {
  const Turn turn(system_->turn, call);
  if (!turn) return Turn::refusal();
  if (!has(character)) return turn.refuse(no_character);
  if (const char* fault = fault_of(kind); fault != nullptr) return turn.refuse(fault);
  if (of(character).pools.kind_count() == EntityPools::most_kinds) {
    return turn.refuse("a character has at most 15 kinds of entities, with those of the library");
  }
  return of(character).pools.add_kind(kind);
}

bool Characters::reserve_entities(EntityPools::Kind kind, std::size_t count, CharacterId character) {
  const Turn turn(system_->turn, "Characters::reserve_entities");
  if (!turn) return false;
  if (!has(character)) return turn.report(no_character);
  if (kind >= of(character).pools.kind_count()) return turn.report("the character has no entities of this kind");
  if (count > Handle::max_blocks) return turn.report(too_many_entities);
  of(character).pools.pool(kind).reserve(count);
  return true;
}

Result<Handle> Characters::add_shared(std::unique_ptr<Channel> channel, TypeTag type, CharacterId character) {
  const Turn turn(system_->turn, "Characters::add_shared");
  if (!turn) return Turn::refusal();
  if (!has(character)) return turn.refuse(no_character);
  if (channel == nullptr) return turn.refuse("the channel is null");
  Population& population = system_->population;
  AgentGraphs& shared = of(character).shared;
  if (!of(character).pools.has_room()) return turn.refuse(too_many_entities);
  const char* const fault = channel->fault(population.shared_builder(of(character), shared.count()));
  if (fault != nullptr) return turn.refuse(fault);
  const std::uint32_t graph = shared.add();
  const EntityBuilder build = population.shared_builder(of(character), graph);
  Status added = shared.add_channel(build, graph, std::move(channel), type, {});
  if (added && shared.graph(graph).empty()) added = Error{"a shared channel must play something"};
  if (added) added = system_->pus.fit(population, system_->pus.demand(population));
  if (!added) {
    shared.remove(graph);
    return added.error();
  }
  return shared.graph(graph).root();
}

}  // namespace throng::anim
