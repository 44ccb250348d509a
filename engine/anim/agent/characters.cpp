#include "engine/anim/agent/characters.h"

#include <string>
#include <utility>

namespace throng::anim {

Status Characters::configure_again() { return system_->pus.configure(system_->population, system_->pus.options()); }

Result<std::uint32_t> Characters::add(std::shared_ptr<const Character> character) {
  if (count() == most_skeletons) {
    return Error{"a system animates at most " + std::to_string(most_skeletons) + " characters: use another one for \"" +
                 character->skeleton.name + "\""};
  }
  system_->population.add_character(std::move(character));
  const Status configured = configure_again();
  if (configured) return count() - 1;
  system_->population.remove_last_character();
  system_->pus.refresh_contexts(system_->population);
  return configured.error();
}

Status Characters::replace(std::uint32_t character, std::shared_ptr<const Character> reordered,
                           std::span<const int> places) {
  CharacterAgents& agents = of(character);
  if (const std::string bound = agents.bound_to_bone_order(); !bound.empty()) {
    return Error{"the bones of \"" + agents.skeleton().name + "\" keep their order: its agents have " + bound};
  }
  const std::shared_ptr<const Character> before = agents.replace_character(std::move(reordered));
  Status configured = configure_again();
  if (configured) {
    agents.reorder_kept_transforms(places);
    return configured;
  }
  agents.replace_character(before);
  system_->pus.refresh_contexts(system_->population);
  return configured;
}

int Characters::add_mask(BoneMask mask, std::uint32_t character) {
  const int index = of(character).add_mask(std::move(mask));
  system_->pus.refresh_contexts(system_->population);
  return index;
}

std::uint32_t Characters::add_bone_selection(BoneSelection selection, std::uint32_t character) {
  const std::uint32_t index = of(character).add_selection(std::move(selection));
  system_->pus.refresh_contexts(system_->population);
  return index;
}

Result<Handle> Characters::add_shared(std::unique_ptr<Channel> channel, std::uint32_t character) {
  Population& population = system_->population;
  AgentGraphs& shared = of(character).shared;
  const std::uint32_t graph = shared.count();
  shared.resize(graph + 1);
  Status added = shared.add_channel(population.shared_builder(of(character), graph), graph, std::move(channel), {});
  if (added && shared.graph(graph).empty()) added = Error{"a shared channel must play something"};
  if (added) added = system_->pus.fit(population, system_->pus.demand(population));
  if (!added) {
    shared.resize(graph);
    return added.error();
  }
  return shared.graph(graph).root();
}

}  // namespace throng::anim
