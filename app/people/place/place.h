#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/mat4x3.hpp>

#include "throng/render/scene_ground.h"
#include "throng/render/scenery_data.h"

#include "app/character/roles.h"
#include "app/settings/settings.h"

namespace throng::app {

/// The things that places are made of.
enum class Prop : std::uint8_t {
  arcade_bay,
  facade_a,
  facade_b,
  facade_c,
  tower,
  tree_a,
  tree_b,
  tree_c,
  planter,
  lamp,
  bench,
  fountain,
  kiosk,
  steps,
  statue,
  flag,
  bunting,
  barrier,
  bollard,
  stand,
  camera_crane,
  seat_block,
  seat,
  roof_bay,
  goal,
  flood_light,
  banner,
  hill,
  skyline,
  skyline_center,
  facade_d,
  facade_e,
  facade_corner,
  arcade_corner,
};
inline constexpr std::size_t prop_count = 34;

/// The names of the meshes in assets/places.glb, in the order of Prop.
inline constexpr std::array<const char*, prop_count> prop_names = {
    "arcade_bay", "facade_a",       "facade_b", "facade_c", "tower",         "tree_a",       "tree_b",
    "tree_c",     "planter",        "lamp",     "bench",    "fountain",      "kiosk",        "steps",
    "statue",     "flag",           "bunting",  "barrier",  "bollard",       "stand",        "camera_crane",
    "seat_block", "seat",           "roof_bay", "goal",     "flood_light",   "banner",       "hill",
    "skyline",    "skyline_center", "facade_d", "facade_e", "facade_corner", "arcade_corner"};

inline constexpr const char* name_of(Prop prop) { return prop_names[static_cast<std::size_t>(prop)]; }

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
