#pragma once

#include <span>
#include <vector>

#include "app/people/crowd/crowd.h"
#include "app/people/wardrobe/clothing.h"

namespace throng::app {

/// Two people within this many metres of each other when the crowd begins never have the same clothes in the same
/// patterns and colours, unless they wear a uniform or no other clothes are found. Since people walk, few people of the
/// whole crowd have the same clothes.
inline constexpr float alike_reach = 15.0F;
/// Two people who begin within this many metres of each other seldom wear the same clothes above the waist, in crowds
/// of at most 20,000 people.
inline constexpr float upper_alike_reach = 6.0F;

/// Holds what each agent of a crowd wears, [agent].
struct DressedCrowd {
  std::vector<render::AgentLook> looks;
  std::vector<render::Outfit> outfits;
  std::vector<HeldThing> things;       ///< in the agents' hands
  std::vector<std::uint16_t> in_hand;  ///< the pieces of these things, as CrowdLooks has them
};

/// Dresses a crowd where it stands now. `clothing` has one element a character; agents of a character without parts
/// stay as they are. The same crowd, rules and weather give the same clothes.
DressedCrowd dress_crowd(const Crowd& crowd, std::span<const Clothing> clothing, const Tuning& tuning);

/// Gives an agent a jaw, a nose, a brow and eyes of its own. Children's faces differ less.
void give_face(render::AgentLook& look, std::uint32_t agent, std::uint32_t seed, bool is_child);
/// Makes an agent stoop as old people do, one more than another.
void stoop(render::AgentLook& look, std::uint32_t agent, std::uint32_t seed);

}  // namespace throng::app
