#pragma once

#include "app/crowd/layout.h"

namespace throng::app {

/// Lays out a street along z with people on both sides of it: the first agent is the actor, the second the balloon, and
/// all cheer when it flies off. See CutScene.
CrowdLayout cut_scene_layout(std::size_t agents, std::uint32_t seed, const CharacterRoles& roles);

}  // namespace throng::app
