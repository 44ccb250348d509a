#include "app/scenes.h"

#include <algorithm>

#include "app/crowd_layout.h"

namespace throng::app {
namespace {

// Yaw grows counter-clockwise seen from above: 45 degrees look along -X, -Z, from the corner at +X, +Z to the middle.
constexpr float to_the_middle = 45.0F;

std::vector<NamedCamera> plaza_cameras(std::size_t agents, double spacing) {
  const auto unit = static_cast<float>(spacing);
  const auto side = static_cast<float>(plaza_side(agents, spacing));
  const auto corner = static_cast<float>(plaza_viewpoint(agents, spacing).x);
  const float above = 0.9F * side + 8.0F * unit;
  const float beyond = 0.06F * side + 3.0F * unit;
  return {
      {"front", {corner, 2.7F * unit, corner, to_the_middle, -8.5F, 42.0F}},
      {"above", {0.0F, above, 0.55F * above, 0.0F, -64.0F, 50.0F}},
      {"close", {corner - 1.2F * unit, 1.6F * unit, corner - 1.2F * unit, to_the_middle, -6.0F, 40.0F}},
      {"far", {corner + beyond, 0.16F * side + 5.0F * unit, corner + beyond, to_the_middle, -19.0F, 45.0F}},
  };
}

std::vector<NamedCamera> grid_cameras(std::size_t agents, double spacing) {
  const auto unit = static_cast<float>(spacing);
  const auto side = static_cast<float>(static_cast<double>(grid_columns(agents)) * grid_pitch(spacing));
  const float above = 0.75F * side + 6.0F * unit;
  return {
      {"front", {0.0F, 2.2F * unit, 5.0F * unit, 0.0F, -9.0F, 50.0F}},
      {"above", {0.0F, above, 0.5F * (above - side), 0.0F, -64.0F, 50.0F}},
      {"close", {0.0F, 1.3F * unit, 3.0F * unit, 0.0F, -4.0F, 45.0F}},
      {"far", {0.0F, 0.35F * side + 4.0F * unit, 0.6F * side + 10.0F * unit, 0.0F, -20.0F, 45.0F}},
  };
}

}  // namespace

std::vector<NamedCamera> scene_cameras(Scene scene, std::size_t agents, const CharacterRoles& roles) {
  return scene == Scene::plaza ? plaza_cameras(agents, roles.spacing()) : grid_cameras(agents, roles.spacing());
}

const NamedCamera* find_camera(std::span<const NamedCamera> cameras, std::string_view name) {
  if (cameras.empty() || name.empty()) return cameras.empty() ? nullptr : cameras.data();
  const auto found =
      std::find_if(cameras.begin(), cameras.end(), [&](const auto& camera) { return camera.name == name; });
  return found == cameras.end() ? nullptr : &*found;
}

}  // namespace throng::app
