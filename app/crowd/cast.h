#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "app/character/roles.h"
#include "app/crowd/layout.h"

namespace throng::app {

/// The characters of a crowd, and which of them each agent is.
class CrowdCast {
 public:
  /// Chooses for every place of `layout`, by chance but the same for the same seed: of those that can walk for the
  /// walkers, of all people for the standers, of all props where the layout asks for one. Those who march keep step, so
  /// they are all one character, the first that can walk; an actor is that one too. `characters`: 1 to 256, the first
  /// is no prop.
  CrowdCast(std::span<const CharacterRoles> characters, const CrowdLayout& layout, std::uint32_t seed);

  const CharacterRoles& of(std::size_t agent) const { return characters_[numbers_[agent]]; }
  std::span<const std::uint8_t> numbers() const { return numbers_; }  ///< [agent] index of its character
  double spacing() const { return spacing_; }                         ///< CharacterRoles::spacing of the widest

 private:
  std::vector<CharacterRoles> characters_;
  std::vector<std::uint8_t> numbers_;
  double spacing_;
};

/// What a scene is laid out for: the gait of the first character that can walk, the room of the largest person.
CharacterRoles common_roles(std::span<const CharacterRoles> characters);

}  // namespace throng::app
