#pragma once

#include <cstdint>
#include <vector>

#include "app/character/roles.h"
#include "app/people/crowd/cast.h"
#include "app/people/crowd/character_look.h"
#include "app/people/crowd/layout.h"
#include "app/settings/settings.h"

namespace throng::app {

/// How each agent looks and moves apart from the others, [agent].
struct CrowdLooks {
  std::vector<float> scales;         ///< 0.9 to 1.1, times the size of the body
  std::vector<std::uint8_t> bodies;  ///< index among CharacterRoles::bodies; 0 without any
  std::vector<float> radii;          ///< metres
  std::vector<float> paces;          ///< playback speed of a clip in place; of walkers, speed over the clip's
  std::vector<float> start_phases;   ///< 0 to below 1
  std::vector<Tints> tints;
  std::vector<Variant> variants;
  std::vector<std::uint32_t> shades;     ///< AgentLook::shade
  std::vector<render::AgentLook> drawn;  ///< all that drawing reads of them
  std::vector<render::Outfit> outfits;   ///< of a character that has pieces; empty: no agent wears any
  std::vector<std::uint16_t> in_hand;    ///< piece of an outfit, or no_piece; drawn while it is in the hand
  std::uint64_t number = 0;              ///< of `drawn`: no other crowd has it

  /// Dresses all agents: how they look, the pieces of their character's mesh that they wear, and `in_hand`.
  void wear(std::vector<render::AgentLook> new_looks, std::vector<render::Outfit> new_outfits,
            std::vector<std::uint16_t> new_in_hand = {});
};

/// Returns [agent] the habit of each agent of a layout.
std::vector<Habit> habits_of(const CrowdLayout& layout);

/// Gives each agent a size, colours, a pace and a phase. `laid_out_for` is what the layout was made for. Streams of
/// random numbers of their own draw what not every character has, so that no other agent's draws change.
CrowdLooks looks_of(const CrowdLayout& layout, Scene scene, std::uint32_t seed, const CrowdCast& cast,
                    const CharacterRoles& laid_out_for, const Variety& variety);

}  // namespace throng::app
