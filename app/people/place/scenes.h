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

/// These functions put the props of a scene and return its ground.
render::SceneGround put_plaza(const SceneCrowd& crowd, Placer& placer);
render::SceneGround put_parade(const SceneCrowd& crowd, Placer& placer);
render::SceneGround put_film(const SceneCrowd& crowd, Placer& placer);
render::SceneGround put_stadium(const SceneCrowd& crowd, Placer& placer);

}  // namespace throng::app
