#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "engine/anim/agent/system_parts.h"
#include "engine/anim/asset/bone_mask.h"

namespace throng::anim {

/// The characters of an AnimationSystem, and what all agents of one character share. A character has a number: that of
/// AnimationSystem::create is 0. A camera and a prop are characters too. Add things at load time.
class Characters {
 public:
  /// Works on the inside of a system, which outlives this object.
  explicit Characters(SystemParts& system) : system_(&system) {}

  std::uint32_t count() const { return static_cast<std::uint32_t>(system_->population.characters().size()); }
  const Character& operator[](std::uint32_t character) const { return *of(character).character; }
  const EntityPools& pools(std::uint32_t character) const { return of(character).pools; }
  /// Returns the format in which palettes of this character's agents are written.
  PaletteFormat palette_format(std::uint32_t character) const {
    return system_->pus.contexts()[character].palette_format;
  }

  /// Adds a character and returns its number. Errors: the local store is too small for it, or there are most_skeletons
  /// already; then nothing has changed.
  Result<std::uint32_t> add(std::shared_ptr<const Character> character);

  /// Takes the same character with its bones in another order (asset/skeleton_order.h) and other levels, at a frame
  /// boundary; agents go on where they are. `places` has the new index of each bone. If kinds of entities point at
  /// rigs, the host reorders those at once (CharacterRigs::reorder_bones). Older snapshots cannot be restored. Errors:
  /// masks, selections or inertialisers depend on the order, or the local store is too small; then nothing has changed.
  Status replace(std::uint32_t character, std::shared_ptr<const Character> reordered, std::span<const int> places);

  /// Adds weights of bones for requests and layers, made for this character's skeleton, and returns the index for
  /// `PlayRequest::mask`.
  int add_mask(BoneMask mask, std::uint32_t character = 0);
  /// Adds a choice of bones that a player evaluates while the others stand still (paper 3.2, per-bone priorities), made
  /// for this character's skeleton, and returns the number for `PlayRequest::bone_selection`.
  std::uint32_t add_bone_selection(BoneSelection selection, std::uint32_t character = 0);

  /// Adds a kind of entity of the host's own, for channels and post processes that make such entities. `kind` outlives
  /// the system.
  EntityPools::Kind add_entity_kind(const EntityKind& kind, std::uint32_t character = 0) {
    return of(character).pools.add_kind(kind);
  }
  /// Makes room for `count` living entities of a kind: as long as there are no more, making one allocates nothing.
  void reserve_entities(EntityPools::Kind kind, std::size_t count, std::uint32_t character = 0) {
    of(character).pools.pool(kind).reserve(count);
  }

  /// Adds a graph that agents can read. It lives as long as the system, and is updated once a frame, to the clock and
  /// before all agents. Returns the entity whose state it is, a source for what the agents' channels make. The channel
  /// may change its parameters by itself, but its state() stays the same entity. Agents that read it are posed without
  /// look-ahead, and its players keep the stream that they were made for. The errors are those of Agent::add_channel.
  Result<Handle> add_shared(std::unique_ptr<Channel> channel, std::uint32_t character = 0);

 private:
  CharacterAgents& of(std::uint32_t character) { return *system_->population.characters()[character]; }
  const CharacterAgents& of(std::uint32_t character) const { return *system_->population.characters()[character]; }
  Status configure_again();

  SystemParts* system_;
};

}  // namespace throng::anim
