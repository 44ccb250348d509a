#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

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

}  // namespace throng::app
