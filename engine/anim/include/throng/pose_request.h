#pragma once

#include "throng/ids.h"
#include "throng/standard.h"
#include "throng/ticks.h"

namespace throng {

/// One agent to be posed in this frame.
struct PoseRequest {
  AgentId agent{};
  std::uint8_t level = 0;        ///< bone level, 0: all bones
  Ticks look_ahead{};            ///< the pose is for now + look_ahead, for skipped frames that are blended
  std::byte* palette = nullptr;  ///< written there, Crowd::palette_bytes, aligned to 16; null: it is not drawn
  std::byte* joints = nullptr;   ///< Crowd::joint_bytes, aligned to 16; null: none are written
  /// A coarser level, to or from which the pose fades. The bones that it lacks are `fade_halves` halves of the way to
  /// where they stand still. At 2 the palette shows that level's pose, so that meshes can change without a pop.
  std::uint8_t fade_level = 0;
  std::uint8_t fade_halves = 0;  ///< 0 to 2
};

}  // namespace throng
