#pragma once

#include <array>
#include <string>

#include "throng/render/scene_light.h"

namespace throng::app {

struct TimeOfDay {
  const char* name;
  render::SceneLight light;
};

/// The kinds of light that have names. The first is the default.
inline constexpr std::array<TimeOfDay, 4> times_of_day = {{
    {"noon", {}},
    {"evening", {.sun_elevation = 9.0F, .sun_azimuth = 226.0F, .clouds = 0.45F}},
    {"overcast", {.sun_elevation = 40.0F, .clouds = 1.0F}},
    {"night", {.sun_elevation = -12.0F, .sun_azimuth = 226.0F, .clouds = 0.2F}},
}};

/// Returns their names: "noon, evening, overcast or night".
std::string names_of_times();

}  // namespace throng::app
