#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/anim/agent/agent_graphs.h"
#include "engine/anim/agent/agent_motion.h"
#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/entity/kind_memory.h"
#include "engine/anim/run/local_store_plan.h"
#include "engine/anim/run/program/agent_work.h"

namespace throng::anim {

/// The blocks and graphs of all agents of a character at a moment.
struct CharacterAgentsSnapshot {
  std::shared_ptr<const Character> character;
  std::vector<PoolSnapshot> pools;  // own and shared of each kind, in turns
  std::optional<AgentGraphs> agents;
  std::optional<AgentGraphs> shared;

  std::size_t bytes() const;
};

/// The agents of one character, and all that they share: streams, masks, pools, and graphs that several agents read.
/// It never moves, because its parts point at each other.
struct CharacterAgents {
  explicit CharacterAgents(std::shared_ptr<const Character> played);
  CharacterAgents(const CharacterAgents&) = delete;
  CharacterAgents& operator=(const CharacterAgents&) = delete;

  const Skeleton& skeleton() const { return character->skeleton; }
  /// Returns the context that PUs read. It is valid until a mask or a selection is added.
  UpdateContext context(const Kernels& kernels) const;

  /// Returns the data that blends the morphs of its agents. It is valid as long as context().
  MorphBlend morph_blend() const {
    return {.bones = character->morph_bones, .masks = mask_weights, .ranges = mask_ranges};
  }

  /// Takes the same character with other clips, and returns the one before. The played clips keep
  /// their places, as bound_to_clips() says.
  std::shared_ptr<const Character> replace_clips(std::shared_ptr<const Character> other);
  /// Returns why agents cannot go on with the clips of `other`, in a sentence; empty if they can.
  std::string bound_to_clips(const Character& other);
  /// Takes the same character with its bones in another order, and returns the one before.
  std::shared_ptr<const Character> replace_character(std::shared_ptr<const Character> reordered);
  /// Does what AgentGraphs::reorder_bones does, for all graphs; masks weigh the same bones as before.
  void reorder_bones(std::span<const int> places) {
    agents.reorder_bones(places);
    shared.reorder_bones(places);
    reorder_masks(places);
  }
  /// Returns the name of something that depends on the order of the bones, in words; empty if nothing does.
  std::string bound_to_bone_order() const;

  int add_mask(BoneMask mask);
  void reorder_masks(std::span<const int> places);
  std::uint32_t add_selection(BoneSelection selection);

  void set_residency(Residency residency);
  void set_stream(StreamKind stream);
  /// Makes room for one fade of every agent.
  void reserve_fades(StreamKind stream, std::size_t agent_count);

  void snapshot(CharacterAgentsSnapshot& into) const;
  Status restore(const CharacterAgentsSnapshot& from);
  void add_memory(std::vector<KindMemory>& kinds) const;
  std::size_t bytes_alive() const;
  /// Returns the bytes of all palettes, one for each agent.
  std::size_t palette_bytes(PaletteFormat format) const {
    return agents.alive_count() * static_cast<std::size_t>(skeleton().palette_count()) * palette_entry_bytes(format);
  }

  /// Returns the bytes of the list of joints, for an agent.
  std::size_t joint_bytes() const { return joint_programs.empty() ? 0 : joint_programs.front().bytes; }

  std::shared_ptr<const Character> character;
  std::vector<float> still_pose;
  std::vector<ClipStreams> clips;
  std::vector<BoneMask> masks;
  std::vector<const float*> mask_weights;  // [mask], as the context lists them
  std::vector<MaskRange> mask_ranges;      // [mask]
  std::vector<BoneSelection> selections;
  std::vector<JointProgram> joint_programs;  // [level]; empty: no joints are listed
  EntityPools pools;
  ProgramTable programs;  // all graphs find theirs here
  AgentGraphs agents;
  AgentGraphs shared;
};

/// Stands where a character or an agent is gone: a character without bones, and one agent, number 0, without channels.
const CharacterAgents& no_agents();

/// Returns what the agents of all characters together ask of the local stores.
LocalStoreDemand local_store_demand(std::span<const std::unique_ptr<CharacterAgents>> characters, StreamKind stream);

}  // namespace throng::anim
