#include "engine/anim/agent/figures.h"

#include <algorithm>

namespace throng::anim {

double Figures::bytes_per_agent() const {
  const std::size_t bytes = system_->population.bytes() + system_->frame.hashes().bytes();
  return static_cast<double>(bytes) / std::max<double>(system_->population.numbers().count(), 1.0);
}

std::vector<KindMemory> Figures::memory() const {
  std::vector<KindMemory> kinds;
  for (const std::unique_ptr<CharacterAgents>& character : system_->population.characters()) {
    character->add_memory(kinds);
  }
  return kinds;
}

}  // namespace throng::anim
