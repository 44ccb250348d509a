#include "engine/anim/entity/entity_pools.h"

#include <algorithm>
#include <cassert>

#include "engine/anim/entity/additive_layer.h"
#include "engine/anim/entity/ease_blender.h"
#include "engine/anim/entity/held_state.h"
#include "engine/anim/entity/inertialiser.h"
#include "engine/anim/entity/mixer.h"
#include "engine/anim/entity/noise_maker.h"
#include "engine/anim/entity/player.h"

namespace throng::anim {

EntityPools::EntityPools(int bone_count, int components, Residency residency, std::uint32_t max_blocks)
    : bone_count_(bone_count),
      components_(components),
      max_blocks_(max_blocks),
      residency_(residency),
      layouts_(std::size_t{2} * first_shared) {
  own_.reserve(most_kinds);
  shared_.reserve(most_kinds);
  for (const EntityKind* kind : {&sampled_player_kind, &keyframe_player_kind, &ease_blender_kind, &mixer_kind,
                                 &additive_layer_kind, &inertialiser_kind, &noise_maker_kind, &held_state_kind}) {
    add_kind(*kind);
  }
}

EntityPools::Kind EntityPools::add_kind(const EntityKind& kind) {
  assert(kind_count() < most_kinds && "at most 15 kinds of entities a skeleton");
  assert(kind.prepared_bytes % 64 == 0 && kind.prepared_bytes <= most_prepared_bytes);
  assert((kind.pose_packet != nullptr) != (kind.pose_whole != nullptr) && "a kind poses packets or whole poses");
  const Kind index = kind_count();
  layouts_[index] = entity_layout(kind, residency_, bone_count_, components_);
  layouts_[first_shared + index] = entity_layout(kind, Residency::resident, bone_count_, components_);
  own_.emplace_back(index, layouts_[index].total_size, max_blocks_);
  shared_.emplace_back(first_shared + index, layouts_[first_shared + index].total_size, max_blocks_);
  return index;
}

bool EntityPools::has_room() const {
  const auto has_some = [](const Pool& pool) { return pool.room() >= most_at_once; };
  return std::ranges::all_of(own_, has_some) && std::ranges::all_of(shared_, has_some);
}

Handle EntityPools::create(Kind kind, bool shared) {
  const Handle handle = (shared ? shared_ : own_)[kind].create();
  if (!handle.valid()) return handle;
  initialise_state(state(handle), layout(handle), bone_count_, components_);
  return handle;
}

bool EntityPools::alive(Handle handle) const {
  if (!handle.valid() || handle.pool() % first_shared >= kind_count()) return false;
  return pool_of(handle).alive(handle);
}

std::span<Handle> EntityPools::sources(Handle handle) const {
  const EntityLayout& entity = layout(handle);
  if (entity.kind->sources == nullptr) return {};
  return entity.kind->sources(block(handle), entity);
}

void EntityPools::set_residency(Residency residency) {
  if (residency == residency_) return;
  for (Kind kind = 0; kind < kind_count(); ++kind) {
    const EntityLayout from = layouts_[kind];
    const EntityLayout to = entity_layout(*from.kind, residency, bone_count_, components_);
    own_[kind].resize_blocks(to.total_size, [&](const std::byte* old_block, std::byte* new_block) {
      convert_residency(old_block, new_block, from, to);
    });
    layouts_[kind] = to;
  }
  residency_ = residency;
}

void EntityPools::guard_blocks() const {
  for (const Pool& pool : own_) pool.guard_blocks();
  for (const Pool& pool : shared_) pool.guard_blocks();
}

void EntityPools::release_blocks() const {
  for (const Pool& pool : own_) pool.release_blocks();
  for (const Pool& pool : shared_) pool.release_blocks();
}

}  // namespace throng::anim
