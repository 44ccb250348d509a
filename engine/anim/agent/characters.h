#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include "throng/ids.h"

#include "engine/anim/agent/system_parts.h"
#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/base/type_tag.h"
#include "engine/base/result.h"

namespace throng::anim {

/// The characters of an AnimationSystem, and what all agents of one character share. The first is number 0. A camera
/// and a prop are characters too. Characters come and go at frame boundaries; the shared parts of a character are set
/// before its agents use them. An id of no character is refused.
class Characters {
 public:
  /// Works on the inside of a system, which outlives this object.
  explicit Characters(SystemParts& system) : system_(&system) {}

  /// Returns a number above all characters' numbers.
  std::uint32_t count() const { return static_cast<std::uint32_t>(system_->population.characters().size()); }
  bool has(CharacterId character) const { return system_->population.has(character); }
  /// Returns a character; one without bones and clips if none has this id.
  const Character& operator[](CharacterId character) const { return *of(character).character; }
  const EntityPools& pools(CharacterId character) const { return of(character).pools; }
  /// Returns the format in which palettes of this character's agents are written.
  PaletteFormat palette_format(CharacterId character) const;

  /// Adds a character. Errors: it is null or has no bones, the local store is too small for it, or there are
  /// most_skeletons already; then nothing has changed.
  Result<CharacterId> add(std::shared_ptr<const Character> character);
  /// Removes a character, and lets go of it. Errors: agents play it, or it is the only one.
  Status remove(CharacterId character);

  /// Takes the same character with its bones in another order (asset/skeleton_order.h) and other levels, at a frame
  /// boundary; agents go on where they are. `places` has the new index of each bone. If kinds of entities point at
  /// rigs, the host reorders the rigs before (CharacterRigs::reorder_bones). Older snapshots cannot be restored.
  /// Errors: bones move while selections or lists of joints depend on them, or the local store is too small; then
  /// nothing has changed.
  Status replace(CharacterId character, std::shared_ptr<const Character> reordered, std::span<const int> places);

  /// Takes the same character with other clips (bake/clip_set.h), at a frame boundary, and lets go of the one before.
  /// Agents go on where they are, to the bit. Older snapshots cannot be restored, and keep the clips that they know.
  ///
  /// Errors: it has another skeleton, or its bones in another order. An agent plays a clip that leaves its place
  /// (during a fade away from it too, and after an interrupted fade until it is posed twice). A blend space or state
  /// machine has such a clip. A place goes from one clip to another at once. A local store of a fixed size is too
  /// small. Then nothing has changed.
  Status replace_clips(CharacterId character, std::shared_ptr<const Character> other);

  /// Sets which joints an update writes of each agent of this character, to PoseRequest::joints, instead of a palette
  /// or beside it: all joints (all_joints), chosen joints for sockets and hits (joints_of), or palettes in the order of
  /// a glTF skin (joints_of_skin) or as 4x4 matrices. An agent without a wanted palette or hash is posed as far as its
  /// joints need, if it shows clips alone. Every joint is written at every bone level. The hash knows nothing of
  /// joints, and the order of bones stays. An empty list: none. Errors: those of compile_joints, or a local store of a
  /// fixed size is too small; then nothing has changed.
  Status write_joints(const JointList& list, JointFormat format, CharacterId character = 0);
  /// Returns the bytes that an update writes to PoseRequest::joints; 0: the character lists no joints.
  std::size_t joint_bytes(CharacterId character = 0) const { return of(character).joint_bytes(); }

  /// Adds weights of bones for requests and layers, and returns the number for `PlayRequest::mask`. The mask is made
  /// for this character's skeleton, and there are fewer than 32,767; else the number is PlayRequest::no_mask.
  int add_mask(BoneMask mask, CharacterId character = 0);
  /// Adds a choice of bones that a player evaluates while the others stand still (paper 3.2, per-bone priorities), and
  /// returns the number for `PlayRequest::bone_selection`. The choice is made for this character's skeleton; else the
  /// number is Player::every_bone.
  std::uint32_t add_bone_selection(BoneSelection selection, CharacterId character = 0);

  /// Adds a kind of entity of the host's own, for channels and post processes that make such entities. `kind` outlives
  /// the system. Errors: the character has EntityPools::most_kinds already, or the kind is not whole.
  Result<EntityPools::Kind> add_entity_kind(const EntityKind& kind, CharacterId character = 0,
                                            const char* call = "Characters::add_entity_kind");
  /// Makes room for `count` living entities of a kind: as long as there are no more, making one allocates nothing.
  bool reserve_entities(EntityPools::Kind kind, std::size_t count, CharacterId character = 0);

  /// Adds a graph that agents can read. It lives as long as the system, and is updated once a frame, to the clock and
  /// before all agents. Returns the entity whose state it is, a source for what the agents' channels make. The channel
  /// may change its parameters by itself, but its state() stays the same entity. Agents that read it are posed without
  /// look-ahead, and its players keep the stream that they were made for. The errors are those of Agent::add_channel.
  template <typename Derived>
  Result<Handle> add_shared(std::unique_ptr<Derived> channel, CharacterId character = 0) {
    return add_shared(std::move(channel), type_tag<Derived>(), character);
  }

 private:
  CharacterAgents& of(CharacterId character) { return *system_->population.characters()[character.number]; }
  const CharacterAgents& of(CharacterId character) const;
  Status configure_again();
  Result<Handle> add_shared(std::unique_ptr<Channel> channel, TypeTag type, CharacterId character);

  SystemParts* system_;
};

}  // namespace throng::anim
