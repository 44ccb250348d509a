#include "app/show/camera/scenes.h"

#include <algorithm>

#include "app/people/crowd/layout.h"
#include "app/people/crowd/parade.h"
#include "app/people/crowd/plaza_plan.h"
#include "app/people/crowd/stadium.h"
#include "app/people/crowd/tower_view.h"

namespace throng::app {
namespace {

// Yaw grows counter-clockwise seen from above: 45 degrees look along -X, -Z, from the corner at +X, +Z to the middle.
constexpr float to_the_middle = 45.0F;

// Across the fountain to the tower behind it, from a little beside the way between them.
NamedCamera fountain_camera(std::size_t agents, double spacing, Clothes clothes) {
  const auto unit = static_cast<float>(spacing);
  const glm::vec2 fountain(plaza_fountain(agents, spacing, clothes));
  const bool is_small = plaza_side(agents, spacing, clothes) < 12.0 * spacing;  // trees stand close around the fountain
  const glm::vec2 corner(plaza_viewpoint(agents, spacing, clothes));
  const glm::vec2 eye = is_small ? corner : fountain + glm::vec2(8.6F, 10.2F) * unit;
  return {"fountain", {eye.x, 2.1F * unit, eye.y, 40.0F, 0.5F, 46.0F}};
}

std::vector<NamedCamera> plaza_cameras(std::size_t agents, double spacing, Clothes clothes, const NamedCamera& tower) {
  const auto unit = static_cast<float>(spacing);
  const auto side = static_cast<float>(plaza_side(agents, spacing, clothes));
  const auto corner = static_cast<float>(plaza_viewpoint(agents, spacing, clothes).x);
  const float above = 0.9F * side + 8.0F * unit;
  const float beyond = 0.06F * side + 3.0F * unit;
  return {
      {"front", {corner, 2.7F * unit, corner, to_the_middle, -8.5F, 42.0F}},
      {"above", {0.0F, above, 0.55F * above, 0.0F, -64.0F, 50.0F}},
      {"close", {corner - 1.2F * unit, 1.6F * unit, corner - 1.2F * unit, to_the_middle, -6.0F, 40.0F}},
      {"far", {corner + beyond, 0.16F * side + 5.0F * unit, corner + beyond, to_the_middle, -19.0F, 45.0F}},
      tower,
      fountain_camera(agents, spacing, clothes),
  };
}

// The camera comes nearer to a long, low character than its room needs, and stands as low as the character.
std::vector<NamedCamera> grid_cameras(std::size_t agents, const CharacterRoles& roles, const NamedCamera& tower) {
  const auto unit = static_cast<float>(roles.spacing()), tall = static_cast<float>(roles.size());
  const auto side = static_cast<float>(static_cast<double>(grid_columns(agents)) * grid_pitch(roles.spacing()));
  const float above = 0.75F * side + 6.0F * unit;
  const float near = std::max(tall, 0.5F * unit), lower = near - tall;
  return {
      {"front", {0.0F, 2.2F * near - 1.4F * lower, 5.0F * near, 0.0F, -9.0F, 50.0F}},
      {"above", {0.0F, above, 0.5F * (above - side), 0.0F, -64.0F, 50.0F}},
      {"close", {0.0F, 1.3F * near - 1.1F * lower, 3.0F * near, 0.0F, -4.0F, 45.0F}},
      {"far", {0.0F, 0.35F * side + 4.0F * unit, 0.6F * side + 10.0F * unit, 0.0F, -20.0F, 45.0F}},
      tower,
  };
}

// The companies come along the straight at z = -radius, towards +X.
std::vector<NamedCamera> parade_cameras(std::size_t agents, const CharacterRoles& roles, const NamedCamera& tower) {
  const auto unit = static_cast<float>(roles.spacing());
  const ParadeSize size = parade_size(agents, roles);
  const auto straight = static_cast<float>(size.radius), wide = static_cast<float>(size.half_width);
  const auto ahead = static_cast<float>(0.5 * size.half_length) + 7.0F * unit;
  const auto across = static_cast<float>(2.0 * (size.half_length + size.radius + size.half_width));
  const auto end =
      static_cast<float>(size.half_length + size.radius + size.outside) + 2.2F * unit;  // before the houses
  const float above = 0.62F * across + 10.0F * unit;  // above the roofs beside the street
  const CameraPose front{ahead, 2.6F * unit, -straight - wide - 0.4F * unit, 105.0F, -7.5F, 42.0F};
  // A single file has trees beside it.
  const CameraPose street{std::min(ahead + 9.0F * unit, end), 1.7F * unit, 0.3F * wide - straight, 90.0F, 1.0F, 34.0F};
  return {
      {"front", front},
      {"above", {0.0F, above, 0.3F * above, 0.0F, -73.0F, 50.0F}},
      {"close", {ahead - 2.0F * unit, 1.6F * unit, -straight - 0.3F * unit, 92.0F, -4.0F, 45.0F}},
      {"far", {-end, 0.1F * across + 8.0F * unit, 0.9F * straight, -84.0F, -15.0F, 50.0F}},
      tower,
      {"street", wide > 0.0F ? street : front},
  };
}

std::vector<NamedCamera> stadium_cameras(std::size_t agents, const CharacterRoles& roles, const NamedCamera& tower) {
  const auto unit = static_cast<float>(roles.spacing());
  const StadiumSize size = stadium_size(agents, roles);
  const auto length = static_cast<float>(size.half_length), width = static_cast<float>(size.half_width);
  const auto depth = static_cast<float>(size.depth), height = static_cast<float>(size.height);
  const float above = 1.5F * (length + depth) + 6.0F * unit;
  const CameraPose front{0.55F * length, 0.62F * height + 2.2F * unit, width + 0.62F * depth, 46.0F, -7.0F, 46.0F};
  const CameraPose tiers{0.35F * length, 0.4F * height + 2.0F * unit, width + 0.4F * depth - 2.2F * unit, 108.0F, -6.0F,
                         40.0F};
  const bool has_tiers = depth > 3.0F * unit;  // behind one another
  return {
      {"front", front},
      {"above", {0.0F, above, 0.45F * above, 0.0F, -66.0F, 50.0F}},
      {"close", {0.0F, 1.6F * unit, 4.5F * unit - width, 0.0F, 2.0F, 45.0F}},
      {"far", {0.9F * length, height + 6.0F * unit, width + depth - unit, 35.0F, -19.0F, 55.0F}},
      tower,
      {"tiers", has_tiers ? tiers : front},
      {"pitch", {-0.35F * length, 1.5F * unit, 0.3F * width, -38.0F, 5.0F, 52.0F}},
  };
}

std::vector<NamedCamera> cut_scene_cameras(double spacing, const NamedCamera& tower) {
  const auto unit = static_cast<float>(spacing);
  return {
      {"front", {0.9F * unit, 1.5F * unit, 4.2F * unit, 10.0F, -3.0F, film_field_of_view}},
      {"above", {0.0F, 16.0F * unit, 7.0F * unit, 0.0F, -64.0F, 50.0F}},
      {"close", {-0.9F * unit, 1.5F * unit, 2.2F * unit, -20.0F, -3.0F, 45.0F}},
      {"far", {3.0F * unit, 5.0F * unit, 13.0F * unit, 14.0F, -15.0F, 45.0F}},
      tower,
  };
}

}  // namespace

std::span<const char* const> scene_camera_names(Scene scene) {
  static constexpr std::array plaza = {"front", "above", "close", "far", "tower", "fountain"};
  static constexpr std::array parade = {"front", "above", "close", "far", "tower", "street"};
  static constexpr std::array tracks = {"front", "above", "close", "far", "tower", "top"};
  static constexpr std::array stadium = {"front", "above", "close", "far", "tower", "tiers", "pitch"};
  switch (scene) {
    case Scene::plaza:
      return plaza;
    case Scene::parade:
      return parade;
    case Scene::stadium:
      return stadium;
    case Scene::tracks:
      return tracks;
    case Scene::grid:
    case Scene::film:
      break;
  }
  return std::span(plaza).first<5>();
}

std::vector<NamedCamera> scene_cameras(Scene scene, std::size_t agents, const CharacterRoles& roles, Clothes clothes) {
  const NamedCamera tower{"tower", tower_view(scene, agents, roles, clothes)};
  switch (scene) {
    case Scene::plaza:
      return plaza_cameras(agents, roles.spacing(), clothes, tower);
    case Scene::parade:
      return parade_cameras(agents, roles, tower);
    case Scene::stadium:
      return stadium_cameras(agents, roles, tower);
    case Scene::film:
      return cut_scene_cameras(roles.spacing(), tower);
    case Scene::grid:
    case Scene::tracks:
      break;
  }
  return grid_cameras(agents, roles, tower);
}

const NamedCamera* find_camera(std::span<const NamedCamera> cameras, std::string_view name) {
  if (cameras.empty() || name.empty()) return cameras.empty() ? nullptr : cameras.data();
  const auto found =
      std::find_if(cameras.begin(), cameras.end(), [&](const auto& camera) { return camera.name == name; });
  return found == cameras.end() ? nullptr : &*found;
}

}  // namespace throng::app
