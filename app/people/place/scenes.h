#pragma once

#include <cstddef>
#include <cstdint>

#include "app/character/roles.h"
#include "app/people/place/placer.h"
#include "app/settings/settings.h"

namespace throng::app {

/// The crowd of a scene, as far as its place follows from it.
struct SceneCrowd {
  std::size_t agents;
  std::uint32_t seed;
  const CharacterRoles& roles;
  Clothes clothes;
};

/// These functions put the props of a scene.
void put_plaza(const SceneCrowd& crowd, Placer& placer);
void put_parade(const SceneCrowd& crowd, Placer& placer);
void put_film(const SceneCrowd& crowd, Placer& placer);
void put_stadium(const SceneCrowd& crowd, Placer& placer);

/// These functions return the ground of a scene.
render::SceneGround plaza_ground(const SceneCrowd& crowd);
render::SceneGround parade_ground(const SceneCrowd& crowd);
render::SceneGround film_ground(const SceneCrowd& crowd);
render::SceneGround stadium_ground(const SceneCrowd& crowd);

}  // namespace throng::app
