#pragma once

#include <cstddef>

#include "app/character/roles.h"
#include "app/settings/settings.h"

namespace throng::app {

/// Returns a camera that sees all of a scene, as from a tower at its side: people in the foreground, houses and sky
/// behind the crowd. Clothes that form a pattern form it in this camera's picture.
CameraPose tower_view(Scene scene, std::size_t agents, const CharacterRoles& roles, Clothes clothes);

}  // namespace throng::app
