#pragma once

#include <cstddef>
#include <cstdint>

#include "app/character/roles.h"
#include "app/people/place/placer.h"
#include "app/settings/settings.h"

namespace throng::app {

/// The crowd of a scene, as far as its place follows from it.
struct PlacedCrowd {
  std::size_t agents;
  std::uint32_t seed;
  const CharacterRoles& roles;
  Clothes clothes;
};

/// These functions put the props of a scene.
void put_plaza(const PlacedCrowd& crowd, Placer& placer);
void put_parade(const PlacedCrowd& crowd, Placer& placer);
void put_film(const PlacedCrowd& crowd, Placer& placer);
void put_stadium(const PlacedCrowd& crowd, Placer& placer);

/// These functions return the ground of a scene.
render::SceneGround plaza_ground(const PlacedCrowd& crowd);
render::SceneGround parade_ground(const PlacedCrowd& crowd);
render::SceneGround film_ground(const PlacedCrowd& crowd);
render::SceneGround stadium_ground(const PlacedCrowd& crowd);

}  // namespace throng::app
