#pragma once

#include <array>
#include <cstddef>

#include "engine/anim/base/pool.h"
#include "engine/anim/entity/entity_layout.h"

namespace throng::anim {

/// Lists by type and size (paper 2.2.7): one pool a kind of entity, for one skeleton. A handle's pool number is its
/// kind, so that the scheduler knows a block's size without touching it.
class EntityPools {
 public:
  enum Kind : std::uint32_t { sampled_players, keyframe_players, ease_blenders, kind_count };
  static constexpr std::array<EntityType, kind_count> types = {EntityType::sampled_player, EntityType::keyframe_player,
                                                               EntityType::ease_blender};

  EntityPools(int bone_count, int components, Residency residency)
      : bone_count_(bone_count),
        components_(components),
        residency_(residency),
        layouts_(all_layouts(residency)),
        pools_{make(0), make(1), make(2)} {}

  Handle create(Kind kind) {
    const Handle handle = pools_[kind].create();
    initialise_state(*reinterpret_cast<AnimationStateHeader*>(block(handle)), types[kind], layout(kind), bone_count_,
                     components_);
    return handle;
  }
  void destroy(Handle handle) { pools_[handle.pool()].destroy(handle); }

  std::byte* block(Handle handle) const { return pools_[handle.pool()].block(handle); }
  template <typename Entity>
  Entity& as(Handle handle) const {
    return *reinterpret_cast<Entity*>(block(handle));
  }

  const EntityLayout& layout(std::uint32_t kind) const { return layouts_[kind]; }
  const EntityLayout& layout(Handle handle) const { return layouts_[handle.pool()]; }

  Pool& pool(Kind kind) { return pools_[kind]; }
  const Pool& pool(Kind kind) const { return pools_[kind]; }
  Residency residency() const { return residency_; }

  /// At a frame boundary. Handles stay valid; transforms are made anew by the next update.
  void set_residency(Residency residency) {
    if (residency == residency_) return;
    const auto layouts = all_layouts(residency);
    for (std::uint32_t kind = 0; kind < kind_count; ++kind) {
      pools_[kind].resize_blocks(layouts[kind].total_size, [&](const std::byte* old_block, std::byte* new_block) {
        convert_residency(old_block, new_block, layouts_[kind], layouts[kind]);
      });
    }
    layouts_ = layouts;
    residency_ = residency;
  }

  void guard_blocks() const {
    for (const Pool& pool : pools_) pool.guard_blocks();
  }
  void release_blocks() const {
    for (const Pool& pool : pools_) pool.release_blocks();
  }

 private:
  using Layouts = std::array<EntityLayout, kind_count>;

  Layouts all_layouts(Residency residency) const {
    Layouts layouts;
    for (std::uint32_t kind = 0; kind < kind_count; ++kind) {
      layouts[kind] = entity_layout(types[kind], residency, bone_count_, components_);
    }
    return layouts;
  }
  Pool make(std::uint32_t kind) const { return {kind, layouts_[kind].total_size}; }

  int bone_count_;
  int components_;
  Residency residency_;
  Layouts layouts_;
  std::array<Pool, kind_count> pools_;
};

}  // namespace throng::anim
