#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/anim/base/pool.h"
#include "engine/anim/entity/entity_layout.h"

namespace throng::anim {

/// The pools of one skeleton: lists by type and size (paper 2.2.7). Each kind of entity has a pool for entities that
/// one agent reads, and one for entities that several agents share, which are resident under every schedule. The pool
/// number in a handle tells kind and sharing, so the scheduler knows a block's size without touching it.
class EntityPools {
 public:
  using Kind = std::uint32_t;
  /// The kinds that every skeleton has.
  enum : Kind {
    sampled_players,
    keyframe_players,
    ease_blenders,
    mixers,
    additive_layers,
    inertialisers,
    noise_makers,
    held_states,
    usual_kinds
  };
  static constexpr Kind most_kinds = 15;

  /// At most `max_blocks` entities of a kind live at a time.
  EntityPools(int bone_count, int components, Residency residency, std::uint32_t max_blocks = Handle::max_blocks);

  /// Adds a kind at load time. `kind` outlives the pools.
  Kind add_kind(const EntityKind& kind);
  Kind kind_count() const { return static_cast<Kind>(own_.size()); }
  const EntityKind& kind(Handle handle) const { return *layout(handle).kind; }

  /// Returns true if every kind has room for the entities of one more channel or post process.
  bool has_room() const;

  /// Creates a block with its system information filled in. The handle is invalid if there is no room.
  Handle create(Kind kind, bool shared = false);
  void destroy(Handle handle) { pool_of(handle).destroy(handle); }
  bool alive(Handle handle) const;

  std::byte* block(Handle handle) const { return pool_of(handle).block(handle); }
  template <typename Entity>
  Entity& as(Handle handle) const {
    return *reinterpret_cast<Entity*>(block(handle));
  }
  AnimationStateHeader& state(Handle handle) const { return as<AnimationStateHeader>(handle); }
  std::span<Handle> sources(Handle handle) const;
  /// Returns the private part, behind header and transforms.
  template <typename Private>
  Private& private_as(Handle handle) const {
    return *reinterpret_cast<Private*>(block(handle) + layout(handle).private_offset);
  }

  static constexpr bool is_shared(Handle handle) { return handle.pool() >= first_shared; }
  const EntityLayout& layout(Handle handle) const { return layouts_[handle.pool()]; }
  /// Returns the layout of a kind's entities that one agent reads.
  const EntityLayout& layout(Kind kind) const { return layouts_[kind]; }

  const Pool& pool_of(Handle handle) const {
    return is_shared(handle) ? shared_[handle.pool() - first_shared] : own_[handle.pool()];
  }
  Pool& pool(Kind kind) { return own_[kind]; }
  const Pool& pool(Kind kind) const { return own_[kind]; }
  Pool& shared_pool(Kind kind) { return shared_[kind]; }
  const Pool& shared_pool(Kind kind) const { return shared_[kind]; }
  Residency residency() const { return residency_; }

  /// Changes the layout of all blocks, at a frame boundary. Handles stay valid. The next update makes transforms anew.
  void set_residency(Residency residency);

  void guard_blocks() const;
  void release_blocks() const;

 private:
  static constexpr std::uint32_t first_shared = 16;
  static constexpr std::size_t most_at_once = 32;  // of a kind, in one channel or post process

  Pool& pool_of(Handle handle) { return const_cast<Pool&>(std::as_const(*this).pool_of(handle)); }

  int bone_count_;
  int components_;
  std::uint32_t max_blocks_;
  Residency residency_;
  std::vector<EntityLayout> layouts_;  // [kind] own, [first_shared + kind] shared
  std::vector<Pool> own_;              // [kind]
  std::vector<Pool> shared_;           // [kind]
};

}  // namespace throng::anim
