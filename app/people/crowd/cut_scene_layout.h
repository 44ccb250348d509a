#pragma once

#include "app/people/crowd/layout.h"

namespace throng::app {

/// Lays out a street along z with people on both sides of it: the first agent is the actor, the second the balloon, and
/// all cheer when it flies off. See CutScene.
CrowdLayout cut_scene_layout(std::size_t agents, std::uint32_t seed, const CharacterRoles& roles);

/// The street of a cut scene, in metres: along z between two ends, with people up to `half_width` from its middle.
struct CutSceneStreet {
  double half_road;  ///< kept free for the actor
  double half_width;
  double first_end, last_end;  ///< z
};
CutSceneStreet cut_scene_street(std::size_t agents, const CharacterRoles& roles);

}  // namespace throng::app
