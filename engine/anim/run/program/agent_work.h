#pragma once

#include <cstdint>
#include <span>

#include "engine/anim/base/transform.h"
#include "engine/anim/base/units.h"
#include "engine/anim/entity/entity_pools.h"
#include "engine/anim/entity/player.h"
#include "engine/anim/kernel/kernels.h"
#include "engine/anim/kernel/palette/hierarchy.h"
#include "engine/anim/kernel/palette/joint_program.h"
#include "engine/anim/run/program/pose_program.h"

namespace throng::anim {

inline constexpr std::size_t most_skeletons = 32;  ///< the most in one update

/// One agent to be posed in this frame. It is read-only while PUs run. It is small, since it is sorted. It has no bit
/// fields, because their bytes would have to be read back before they can be copied.
struct AgentWork {
  const PoseProgram* program = nullptr;
  const Handle* entities = nullptr;  ///< [step of the program]; they stay where they are until the update is over
  Ticks delta{};                     ///< since its last update
  PaletteDestination palette = {};   ///< written once; null: posed, but not drawn
  std::uint32_t agent = 0;
  std::uint16_t cost = 1;        ///< predicted, in steps of cost_step
  std::uint8_t skeleton = 0;     ///< index of its UpdateContext, below most_skeletons
  std::uint8_t level = 0;        ///< bone level
  std::uint8_t fade_level = 0;   ///< bones that this level lacks ...
  std::uint8_t fade_halves = 0;  ///< ... are so far on their way to where they stand still, 0 to 2
  bool held = false;             ///< StoreNeeds::held of the program
};
static_assert(sizeof(AgentWork) == (sizeof(void*) == 8 ? 48 : 32));

/// All that PUs share about one skeleton for the length of an update. It is read-only, except for the pools' blocks,
/// which only copies reach.
struct UpdateContext {
  const HierarchyProgram* hierarchy = nullptr;
  PaletteFormat palette_format = PaletteFormat::matrices;  ///< the format of all palettes of this skeleton
  EntityAssets assets;
  std::span<const int> level_bone_counts;
  const EntityPools* pools = nullptr;
  std::span<const float> still_pose{};  ///< asset/still_pose.h
  std::span<std::uint64_t> hashes{};    ///< [agent] out: the sum of its palette's entry hashes; or empty
  const Skeleton* locals_of = nullptr;  ///< not null: destinations get local transforms of its bones, not palettes
  std::span<const JointProgram> joint_programs{};   ///< [level] the joints beside palettes; or empty
  std::span<const PaletteDestination> joints_to{};  ///< [agent] the place for its joints; or empty

  int bones(int level) const { return level_bone_counts[static_cast<std::size_t>(level)]; }
  int packets(int level) const { return packets_for(bones(level)); }
  std::size_t packet_floats() const { return packet_bytes(assets.components) / sizeof(float); }
};

}  // namespace throng::anim
