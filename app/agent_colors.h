#pragma once

#include <cstdint>

#include "app/settings.h"
#include "engine/anim/run/lod.h"

namespace throng::app {

/// The colour (RGBA8, sRGB, red in the lowest byte) that a debug view lays over an agent; 0: none.
std::uint32_t debug_color(DebugView view, const anim::VisibleAgent& agent, int bone_level);

/// Of whoever was clicked at: the overlay's own colour, so that card and character are seen to belong together.
inline constexpr std::uint32_t selected_color = 0xB0AEBF48;

/// One of a short row of colours that are told apart at a glance, from green (full detail) to red.
std::uint32_t step_color(int step, int steps);

}  // namespace throng::app
