#include "engine/anim/agent/animation_system.h"

#include <utility>

namespace throng::anim {

Result<std::unique_ptr<AnimationSystem>> AnimationSystem::create(std::shared_ptr<const Character> character,
                                                                 const SystemOptions& options) {
  std::unique_ptr<AnimationSystem> system(new AnimationSystem());
  system->parts_.population.add_character(std::move(character));
  const Status configured = system->configure(options);
  if (!configured) return configured.error();
  return system;
}

Status AnimationSystem::configure(const SystemOptions& options) {
  return parts_.pus.configure(parts_.population, options);
}

void AnimationSystem::set_agent_count(std::uint32_t agents) {
  parts_.population.resize(agents);
  agents_changed();
}

std::uint32_t AnimationSystem::add_agents(std::uint32_t count, std::uint32_t character) {
  const std::uint32_t first = parts_.population.add(count, character);
  agents_changed();
  return first;
}

std::uint32_t AnimationSystem::add_agents(std::span<const std::uint8_t> characters) {
  const std::uint32_t first = parts_.population.add(characters);
  agents_changed();
  return first;
}

void AnimationSystem::agents_changed() {
  parts_.frame.reserve(agent_count());
  parts_.pus.reserve(parts_.population);
}

void AnimationSystem::restart() {
  parts_.population.restart();
  parts_.frame.restart();
}

}  // namespace throng::anim
