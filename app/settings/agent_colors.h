#pragma once

#include <cstdint>

#include "app/settings/settings.h"

namespace throng::app {

/// The figures of an agent that debug views show.
struct AgentDetail {
  int interval = 1;        ///< frames
  int bone_level = 0;      ///< the level of the pose shown
  float error_px = -1.0F;  ///< the error on screen; below 0: not measured
};

/// Returns the colour (RGBA8, sRGB, red in the lowest byte) that a debug view lays over an agent; 0: none.
std::uint32_t debug_color(DebugView view, const AgentDetail& detail);

/// Returns the step of an error on screen, 0 to 5: below a quarter of a pixel, a half, 1, 2, 4, and more.
int error_step(float pixels);
inline constexpr int error_steps = 6;

/// The colour of the selected agent, which is the overlay's own, so that card and character seem to belong together.
inline constexpr std::uint32_t selected_color = 0xB0AEBF48;

/// Returns the colour of a step, from green (full detail) to red. People tell these colours apart at a glance.
std::uint32_t step_color(int step, int steps);

}  // namespace throng::app
