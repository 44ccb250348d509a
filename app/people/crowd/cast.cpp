#include "app/people/crowd/cast.h"

#include <algorithm>
#include <cassert>

#include "app/people/crowd/numbers/shares.h"
#include "engine/base/random.h"

namespace throng::app {
namespace {

constexpr std::uint64_t cast_stream = 7;

using Numbers = std::vector<std::uint8_t>;

Numbers those_who(std::span<const CharacterRoles> characters, bool (*do_it)(const CharacterRoles&)) {
  Numbers numbers;
  for (std::size_t i = 0; i < characters.size(); ++i) {
    if (do_it(characters[i])) numbers.push_back(static_cast<std::uint8_t>(i));
  }
  return numbers;
}

bool is_person(const CharacterRoles& character) { return !character.is_prop; }
bool is_prop(const CharacterRoles& character) { return character.is_prop; }
bool can_walk(const CharacterRoles& character) { return is_person(character) && character.can_walk(); }

GaitSpeeds gait_speeds(const CharacterRoles& character) {
  GaitSpeeds speeds;
  for (const Role gait : {Role::walk, Role::jog, Role::run}) {
    const Role played = character.playable(gait).value_or(Role::walk);
    speeds.own[index_of(gait)] = static_cast<float>(character.ground_speed(gait));
    speeds.played[index_of(gait)] = static_cast<float>(character.ground_speed(played));
  }
  return speeds;
}

}  // namespace

CharacterRoles common_roles(std::span<const CharacterRoles> characters) {
  const Numbers walking = those_who(characters, can_walk);
  CharacterRoles common = characters[walking.empty() ? 0 : walking.front()];
  for (const std::uint8_t person : those_who(characters, is_person)) {
    common.height = std::max(common.height, characters[person].height);
    common.radius = std::max(common.radius, characters[person].radius);
  }
  return common;
}

CrowdCast::CrowdCast(std::span<const CharacterRoles> characters, const CrowdLayout& layout, std::uint32_t seed)
    : spacing_(common_roles(characters).spacing()) {
  take_roles(characters);
  assert(!characters_.empty() && characters_.size() <= 256 && is_person(characters_.front()));
  const Numbers walking = those_who(characters, can_walk), people = those_who(characters, is_person);
  const Numbers props = those_who(characters, is_prop);
  assert(!walking.empty() || (layout.walkers.empty() && layout.marchers.empty()));
  const std::uint8_t leader = walking.empty() ? people.front() : walking.front();
  Random random(seed, cast_stream);
  ShareDealer dealer(characters);
  const auto is = [&](Part part) {
    return static_cast<std::size_t>(std::ranges::count(layout.standers, part, &StanderStart::part));
  };
  numbers_ = dealer.deal(walking, layout.walkers.size(), random);
  numbers_.insert(numbers_.end(), layout.marchers.size(), leader);
  const Numbers bystanders = dealer.deal(people, is(Part::bystander), random);
  const Numbers things = dealer.deal(props, is(Part::prop), random);
  auto bystander = bystanders.begin(), thing = things.begin();
  for (const StanderStart& place : layout.standers) {
    if (place.part == Part::actor) numbers_.push_back(leader);
    if (place.part == Part::bystander) numbers_.push_back(*bystander++);
    if (place.part == Part::prop) numbers_.push_back(*thing++);
  }
}

void CrowdCast::take_roles(std::span<const CharacterRoles> characters) {
  characters_.assign(characters.begin(), characters.end());
  speeds_.clear();
  for (const CharacterRoles& character : characters_) speeds_.push_back(gait_speeds(character));
}

}  // namespace throng::app
