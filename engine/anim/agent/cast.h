#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/anim/agent/agents.h"
#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/run/local_store_plan.h"
#include "engine/anim/run/program/agent_work.h"

namespace throng::anim {

/// Main memory of the blocks of one kind, those that agents own and those that they share.
struct KindMemory {
  const char* kind = "";
  PoolMemory own;
  PoolMemory shared;
};

/// Blocks and graphs of a cast as they were.
struct CastSnapshot {
  std::shared_ptr<const Character> character;
  std::vector<PoolSnapshot> pools;  // own and shared of each kind, in turns
  std::optional<Agents> agents;
  std::optional<Agents> shared;

  std::size_t bytes() const;
};

/// The agents of one character and all that they share: streams, masks, pools, graphs that several of them read. Stays
/// where it is, since its parts point at each other.
struct Cast {
  explicit Cast(std::shared_ptr<const Character> played);
  Cast(const Cast&) = delete;
  Cast& operator=(const Cast&) = delete;

  const Skeleton& skeleton() const { return character->skeleton; }
  /// As PUs read it: valid until a mask or a selection is added.
  UpdateContext context(const Kernels& kernels) const;

  /// The same character with its bones in another order; the one before.
  std::shared_ptr<const Character> replace_character(std::shared_ptr<const Character> reordered);
  /// See Agents.
  void reorder_kept_transforms(std::span<const int> places) {
    agents.reorder_kept_transforms(places);
    shared.reorder_kept_transforms(places);
  }
  /// Something of the cast, in words, that holds on to the order of the bones; empty: nothing does.
  std::string bound_to_bone_order() const;

  int add_mask(BoneMask mask);
  std::uint32_t add_selection(BoneSelection selection);

  void set_residency(Residency residency);
  void set_stream(StreamKind stream);
  /// Room for one fade of every agent.
  void reserve_fades(StreamKind stream, std::size_t agent_count);

  void snapshot(CastSnapshot& into) const;
  Status restore(const CastSnapshot& from);
  Compaction compact();
  void add_memory(std::vector<KindMemory>& kinds) const;
  std::size_t bytes_alive() const;
  /// Of one palette of each agent.
  std::size_t palette_bytes(PaletteFormat format) const {
    return agents.count() * static_cast<std::size_t>(skeleton().palette_count()) * palette_entry_bytes(format);
  }

  std::shared_ptr<const Character> character;
  std::vector<float> still_pose;
  std::vector<ClipStreams> clips;
  std::vector<BoneMask> masks;
  std::vector<const float*> mask_weights;  // of masks, as the context lists them
  std::vector<BoneSelection> selections;
  EntityPools pools;
  ProgramTable programs;  // of all graphs
  Agents agents;
  Agents shared;
};

/// What all casts together ask of the local stores.
LocalStoreDemand local_store_demand(std::span<const std::unique_ptr<Cast>> casts, StreamKind stream);

}  // namespace throng::anim
