#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "app/character/roles.h"
#include "app/settings/settings.h"

namespace throng::app {

struct NamedCamera {
  std::string_view name;
  CameraPlace place;
};

/// The cameras of a scene, the default ("front") first: front, above, close, far. They follow the size of the crowd and
/// of the character.
std::vector<NamedCamera> scene_cameras(Scene scene, std::size_t agents, const CharacterRoles& roles);

/// The camera called `name`, null where the scene has none; an empty name is the first.
const NamedCamera* find_camera(std::span<const NamedCamera> cameras, std::string_view name);

}  // namespace throng::app
