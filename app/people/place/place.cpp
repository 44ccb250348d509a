#include "app/people/place/place.h"

#include "app/people/place/placer.h"
#include "app/people/place/scenes.h"

namespace throng::app {
namespace {

constexpr std::uint64_t place_stream = 14;

}  // namespace

Surroundings surroundings_of(Scene scene, std::size_t agents, std::uint32_t seed, const CharacterRoles& roles,
                             Clothes clothes) {
  Surroundings place;
  const SceneCrowd crowd{agents, seed, roles, clothes};
  Placer placer(place, roles.spacing(), Random(seed, place_stream));
  switch (scene) {
    case Scene::plaza:
      place.ground = put_plaza(crowd, placer);
      break;
    case Scene::parade:
      place.ground = put_parade(crowd, placer);
      break;
    case Scene::stadium:
      place.ground = put_stadium(crowd, placer);
      break;
    case Scene::film:
      place.ground = put_film(crowd, placer);
      break;
    case Scene::grid:
    case Scene::tracks:
      break;
  }
  return place;
}

}  // namespace throng::app
