#pragma once

#include <cstdint>

#include "throng/ids.h"

#include "engine/anim/base/units.h"
#include "engine/anim/kernel/palette/packed_palette.h"

namespace throng::anim {

/// One agent to be posed in this frame.
struct AgentUpdate {
  AgentId agent{};
  std::uint8_t level = 0;           ///< bone level
  Ticks look_ahead{};               ///< the pose is for now + look_ahead (smooth skipping); see can_wind_back()
  PaletteDestination palette = {};  ///< the PU writes it there, room for the level's entries; null: none is made
  PaletteDestination joints = {};  ///< the PU writes the character's list of joints there; see Characters::write_joints
  /// A coarser level, to or from which the pose fades. The bones that it lacks are `fade_halves` halves of the way to
  /// where they stand still. At 2 the palette shows that level's pose, so that meshes can change without a pop.
  std::uint8_t fade_level = 0;
  std::uint8_t fade_halves = 0;  ///< 0 to 2
};

}  // namespace throng::anim
