#include "app/people/crowd/tower_view.h"

#include "app/people/crowd/layout.h"
#include "app/people/crowd/parade.h"
#include "app/people/crowd/plaza_plan.h"
#include "app/people/crowd/stadium.h"

namespace throng::app {
namespace {

// From the open corner over the crowd to the far one, where a street leaves between the houses.
CameraPose plaza_tower(std::size_t agents, double spacing, Clothes clothes) {
  const auto unit = static_cast<float>(spacing), side = static_cast<float>(plaza_side(agents, spacing, clothes));
  const auto corner = static_cast<float>(plaza_viewpoint(agents, spacing, clothes).x);
  const float height = 8.0F * unit + 0.085F * side;
  return {corner, height, corner, 45.0F, -17.0F, 45.0F};
}

// From one end along both straights, to the end where a street goes on. Yaw 90 looks along -X.
CameraPose parade_tower(std::size_t agents, const CharacterRoles& roles) {
  const ParadeSize size = parade_size(agents, roles);
  const auto unit = static_cast<float>(roles.spacing());
  const auto end = static_cast<float>(size.half_length + size.radius + size.half_width);
  const auto deep = static_cast<float>(2.0 * (size.radius + size.half_width));
  const float height = 10.0F * unit + 0.3F * deep;
  return {end - 0.3F * height, height, -0.12F * deep, 93.0F, -18.0F, 45.0F};
}

// From above one corner of the last tier, across the field.
CameraPose stadium_tower(std::size_t agents, const CharacterRoles& roles) {
  const StadiumSize size = stadium_size(agents, roles);
  const auto unit = static_cast<float>(roles.spacing()), depth = static_cast<float>(size.depth);
  const auto length = static_cast<float>(size.half_length), width = static_cast<float>(size.half_width);
  const float height = static_cast<float>(size.height) + 0.2F * (length + depth) + 4.0F * unit;
  return {0.45F * length, height, width + depth + unit, 22.0F, -20.0F, 55.0F};
}

// From a little beside the middle, so that the rows do not line up to the camera.
CameraPose grid_tower(std::size_t agents, double spacing) {
  const auto unit = static_cast<float>(spacing);
  const auto side = static_cast<float>(static_cast<double>(grid_columns(agents)) * grid_pitch(spacing));
  const float height = 4.0F * unit + 0.17F * side;
  return {0.2F * side, height, 0.5F * height, 17.0F, -19.0F, 45.0F};
}

CameraPose cut_scene_tower(float unit) { return {3.0F * unit, 22.0F * unit, 24.0F * unit, 7.0F, -38.0F, 45.0F}; }

}  // namespace

CameraPose tower_view(Scene scene, std::size_t agents, const CharacterRoles& roles, Clothes clothes) {
  switch (scene) {
    case Scene::plaza:
      return plaza_tower(agents, roles.spacing(), clothes);
    case Scene::parade:
      return parade_tower(agents, roles);
    case Scene::stadium:
      return stadium_tower(agents, roles);
    case Scene::film:
      return cut_scene_tower(static_cast<float>(roles.spacing()));
    case Scene::grid:
    case Scene::tracks:
      break;
  }
  return grid_tower(agents, roles.spacing());
}

}  // namespace throng::app
