#pragma once

#include <cstdint>
#include <optional>

#include "throng/render/crowd_mesh_data.h"

#include "app/settings/settings.h"

namespace throng::app {

// Every colour that stands for a value, once. Agents, plots, legends and lines in the scene take it from here. The
// colours of a value grow lighter with it, so that people who tell few colours apart see the order too.

/// The figures of an agent that debug views show.
struct AgentDetail {
  int interval = 1;        ///< frames
  int bone_level = 0;      ///< the level of the pose shown
  float error_px = -1.0F;  ///< the error on screen; below 0: not measured
  int mesh_lod = -1;       ///< below 0: not chosen yet
  float measure = -1.0F;   ///< metres a second, people a square metre or seconds, as the view asks; below 0: unknown
};

/// Says what the colours of a view of a measure of people mean: values from 0 to `top` have the colours of a ramp.
struct ColorScale {
  const char* title;
  const char* unit;
  float top = 1.0F;
  float a_unit = 1.0F;  ///< this much of the measure is one of the unit

  friend bool operator==(const ColorScale&, const ColorScale&) = default;
};
/// Returns the scale of the view in force; nothing where it has steps.
std::optional<ColorScale> color_scale(const Tuning& tuning);
/// Returns the colour of a share of a scale, 0 to 1, opaque, so that no clothes change it.
std::uint32_t scale_color(float share);

/// The colour of plain bodies, which is none of a value's, opaque.
inline constexpr std::uint32_t plain_body_color = 0xFFB4B4B4;

/// Returns the colour (RGBA8, sRGB, red in the lowest byte) that the debug view in force lays over an agent, or that of
/// plain bodies where it lays none; 0: none.
std::uint32_t debug_color(const Tuning& tuning, const AgentDetail& detail);

/// Returns the colour of an interval. Intervals beyond eight frames share the last.
inline constexpr int interval_steps = 8;
std::uint32_t interval_color(int frames);
std::uint32_t bone_level_color(int level);

inline constexpr int mesh_lod_steps = render::largest_mesh_lod_count;
std::uint32_t mesh_lod_color(int lod);

/// Returns the step of an error on screen, 0 to 5: below a quarter of a pixel, a half, 1, 2, 4, and more.
int error_step(float pixels);
inline constexpr int error_steps = 6;
/// Returns the pixels below which an error is of a step before the last.
float error_limit(int step);

/// The colour of the selected agent, which is none of a value's, also for people who tell few colours apart.
inline constexpr std::uint32_t selected_color = 0xE0FF50DC;

/// The colour of the lines that show the bounds of a character in the viewer.
inline constexpr std::uint32_t bounds_color = 0xFF54B2F0;

/// Returns the colour of a part of the surface that follows a bone by `weight`, 0 to 1, as the viewer shows it, opaque.
std::uint32_t weight_color(float weight);

}  // namespace throng::app
