#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "app/character/roles.h"
#include "app/settings/settings.h"

namespace throng::app {

struct NamedCamera {
  std::string_view name;
  CameraPose place;
};

/// The vertical field of view of the film's own camera, in degrees.
inline constexpr float film_field_of_view = 50.0F;

/// Returns the names of a scene's cameras, in their order. The first is where a scene begins. Every scene has front,
/// above, close, far and tower; some have more cameras.
std::span<const char* const> scene_camera_names(Scene scene);

/// Returns the cameras of a scene, one a name. They depend on the size of the crowd and of the character, and on
/// whether people stand close because their clothes form a pattern.
std::vector<NamedCamera> scene_cameras(Scene scene, std::size_t agents, const CharacterRoles& roles,
                                       Clothes clothes = Clothes::own);

/// Returns the camera called `name`, or null where the scene has none. The empty name is the first camera's.
const NamedCamera* find_camera(std::span<const NamedCamera> cameras, std::string_view name);

}  // namespace throng::app
