#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/anim/base/pool.h"
#include "engine/anim/base/transform.h"
#include "engine/anim/base/units.h"
#include "engine/anim/entity/entity_pools.h"
#include "engine/anim/entity/player.h"
#include "engine/anim/kernel/hierarchy.h"
#include "engine/anim/kernel/kernels.h"

namespace throng::anim {

/// The entities of one agent's blend tree in the order in which they are evaluated, sources before what blends them
/// (reverse Polish): a player pushes a pose, an ease blender replaces the top two by their blend.
struct BlendTree {
  static constexpr int max_players = 4;
  static constexpr int max_entities = 2 * max_players - 1;

  std::array<Handle, max_entities> entities;
  std::uint8_t count = 0;

  std::span<const Handle> all() const { return {entities.data(), count}; }
  Handle root() const { return entities[count - 1U]; }
};

/// One agent to be posed in this frame. Read-only while PUs run; small, since it is sorted.
struct AgentWork {
  const BlendTree* tree = nullptr;   ///< stays where it is until the update is over
  Ticks delta = 0;                   ///< since its last update
  PaletteMatrix* palette = nullptr;  ///< written once; null: posed, but nobody draws it
  std::uint64_t* hash = nullptr;     ///< out: sum of the palette's entry hashes; or null
  std::uint32_t agent = 0;
  std::uint8_t level = 0;         ///< bone level
  std::uint8_t entity_count = 0;  ///< of the tree
};

/// All that PUs share for the length of an update: read-only, but for the pools' blocks, which only copies reach.
struct UpdateContext {
  const HierarchyProgram* hierarchy = nullptr;
  std::span<const ClipStreams> clips;
  std::span<const float* const> masks;  ///< each [packets][16]
  std::span<const int> level_bone_counts;
  const Kernels* kernels = nullptr;
  const EntityPools* pools = nullptr;
  int bone_count = 0;
  int components = rigid_components;

  int packets(int level) const { return packets_for(level_bone_counts[static_cast<std::size_t>(level)]); }
  const float* mask(std::int16_t index) const { return index < 0 ? nullptr : masks[static_cast<std::size_t>(index)]; }
};

}  // namespace throng::anim
