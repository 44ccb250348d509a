#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "app/character/roles.h"
#include "app/people/crowd/layout.h"

namespace throng::app {

/// The speeds of a character's gaits at scale 1, by Role, in metres a second.
struct GaitSpeeds {
  std::array<float, role_count + 1> own{};     ///< of the gait's own clip; 0: there is none, or it is no gait
  std::array<float, role_count + 1> played{};  ///< of the clip that is played for that gait; 0: it is no gait
};

/// The characters of a crowd. It says which of them each agent is.
class CrowdCast {
 public:
  /// Gives every place of `layout` a character; the seed decides. Walkers are characters that can walk, standers are
  /// people, and a place for a prop gets a prop. Each character has its share of walkers and standers, as exactly as
  /// whole numbers can be, in a shuffled order. Marchers keep step, so all are one character, the first that can walk;
  /// an actor is that character too. `characters`: 1 to 256, the first is no prop.
  CrowdCast(std::span<const CharacterRoles> characters, const CrowdLayout& layout, std::uint32_t seed);

  /// Takes other roles of the same characters, which stay as large as they are. Agents stay the characters that they
  /// are.
  void take_roles(std::span<const CharacterRoles> characters);

  const CharacterRoles& of(std::size_t agent) const { return characters_[numbers_[agent]]; }
  const GaitSpeeds& speeds_of(std::size_t agent) const { return speeds_[numbers_[agent]]; }
  std::span<const std::uint8_t> numbers() const { return numbers_; }  ///< [agent] index of its character
  double spacing() const { return spacing_; }                         ///< CharacterRoles::spacing of the widest

 private:
  std::vector<CharacterRoles> characters_;
  std::vector<GaitSpeeds> speeds_;  // [character]
  std::vector<std::uint8_t> numbers_;
  double spacing_;
};

/// Returns the roles that a scene is laid out for: the gait of the first character that can walk, and the room of the
/// largest person.
CharacterRoles common_roles(std::span<const CharacterRoles> characters);

}  // namespace throng::app
