#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/mat4x3.hpp>

#include "app/character/roles.h"
#include "app/people/place/prop.h"
#include "app/settings/settings.h"
#include "engine/render/scene_ground.h"
#include "engine/render/scenery_data.h"

namespace throng::app {

struct PlacedProp {
  Prop prop;
  glm::mat4x3 place;  ///< from the prop to the world, in metres
  std::uint32_t tint = render::no_tint;
};

/// The things that stand around a crowd, and the ground under it.
struct Surroundings {
  std::vector<PlacedProp> props;
  render::SceneGround ground;
};

/// Returns the place of a scene. It follows from its arguments alone, grows with the crowd, and stands clear of all
/// agents: a prop among people is an obstacle of the crowd's layout. The grid has no place.
Surroundings surroundings_of(Scene scene, std::size_t agents, std::uint32_t seed, const CharacterRoles& roles,
                             Clothes clothes = Clothes::own);

}  // namespace throng::app
