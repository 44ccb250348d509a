#pragma once

#include <span>

namespace throng::anim {

/// Moves floats that are laid out as a pose, [packet][components][16], to the new index of their bone. `places` has it
/// for each bone. Other lanes keep their values.
void reorder_lanes(std::span<const int> places, int components, float* pose);

}  // namespace throng::anim
