#include "app/crowd_cast.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "app/crowd_random.h"

namespace throng::app {
namespace {

constexpr std::uint64_t cast_stream = 7;

using Numbers = std::vector<std::uint8_t>;

Numbers those_who_walk(std::span<const CharacterRoles> characters) {
  Numbers walking;
  for (std::size_t i = 0; i < characters.size(); ++i) {
    if (characters[i].can_walk()) walking.push_back(static_cast<std::uint8_t>(i));
  }
  return walking;
}

void choose(std::size_t count, std::span<const std::uint8_t> from, Random& random, Numbers& chosen) {
  for (std::size_t i = 0; i < count; ++i) {
    chosen.push_back(from[random.below(static_cast<std::uint32_t>(from.size()))]);
  }
}

}  // namespace

CharacterRoles common_roles(std::span<const CharacterRoles> characters) {
  const Numbers walking = those_who_walk(characters);
  CharacterRoles common = characters[walking.empty() ? 0 : walking.front()];
  for (const CharacterRoles& character : characters) {
    common.height = std::max(common.height, character.height);
    common.radius = std::max(common.radius, character.radius);
  }
  return common;
}

CrowdCast::CrowdCast(std::span<const CharacterRoles> characters, const CrowdLayout& layout, std::uint32_t seed)
    : characters_(characters.begin(), characters.end()), spacing_(common_roles(characters).spacing()) {
  assert(!characters_.empty() && characters_.size() <= 256);
  const Numbers walking = those_who_walk(characters);
  assert(!walking.empty() || (layout.walkers.empty() && layout.marchers.empty()));
  Numbers everybody(characters_.size());
  std::iota(everybody.begin(), everybody.end(), std::uint8_t{0});
  Random random(seed, cast_stream);
  choose(layout.walkers.size(), walking, random, numbers_);
  numbers_.insert(numbers_.end(), layout.marchers.size(), walking.empty() ? std::uint8_t{0} : walking.front());
  choose(layout.standers.size(), everybody, random, numbers_);
}

}  // namespace throng::app
