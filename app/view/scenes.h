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

/// Returns the cameras of a scene: front, which is the default, above, close, far. They depend on the size of the crowd
/// and of the character.
std::vector<NamedCamera> scene_cameras(Scene scene, std::size_t agents, const CharacterRoles& roles);

/// Returns the camera called `name`, or null where the scene has none. The empty name is the first camera's.
const NamedCamera* find_camera(std::span<const NamedCamera> cameras, std::string_view name);

}  // namespace throng::app
