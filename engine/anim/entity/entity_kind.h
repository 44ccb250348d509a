#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "engine/anim/asset/bone_priorities.h"
#include "engine/anim/base/pool.h"
#include "engine/anim/entity/animation_state.h"
#include "engine/anim/entity/clip_streams.h"
#include "engine/anim/kernel/kernels.h"
#include "engine/anim/kernel/pose/pose_view.h"

namespace throng::anim {

struct EntityKind;
struct EntityRun;

enum class Residency : std::uint8_t { transient, resident };

/// Says where the parts of an entity's block lie. animation_state.h draws them.
struct EntityLayout {
  const EntityKind* kind = nullptr;
  std::uint32_t total_size = 0;
  std::uint32_t transforms_offset = 0;  ///< 0: transient
  std::uint32_t private_offset = 0;     ///< == total_size where there is no private part

  bool is_resident() const { return transforms_offset != 0; }
  /// Returns the bytes that are fetched of a source: its header and transforms, without the private part.
  std::uint32_t source_bytes() const { return private_offset; }
  std::uint32_t private_bytes() const { return total_size - private_offset; }
  /// Returns the bytes at the start of a block that no function of its kind reads. They are not fetched.
  std::size_t unread_bytes() const;
  bool final_once_advanced() const;
};

/// Read-only memory of one skeleton, which its entities may read beside their own blocks.
struct EntityAssets {
  std::span<const ClipStreams> clips{};
  std::span<const float* const> masks{};  ///< each [packets][16]
  std::span<const BoneSelection> selections{};
  const Kernels* kernels = nullptr;
  int bone_count = 0;
  int components = rigid_components;
  bool prefetch = false;  ///< players ask for their rows before the first packet is sampled

  const float* mask(std::int16_t index) const { return index < 0 ? nullptr : masks[static_cast<std::size_t>(index)]; }
};

/// An entity in the local store.
struct EntityInStore {
  std::byte* block = nullptr;
  std::byte* prepared = nullptr;  ///< EntityKind::prepared_bytes of scratch, from advance to the last packet
  const EntityLayout* layout = nullptr;
  const EntityAssets* assets = nullptr;

  template <typename Entity>
  Entity& as() const {
    return *reinterpret_cast<Entity*>(block);
  }
  template <typename Prepared>
  Prepared& prepared_as() const {
    return *reinterpret_cast<Prepared*>(prepared);
  }
  std::span<std::byte> private_part() const { return {block + layout->private_offset, layout->private_bytes()}; }
  template <typename Private>
  Private& private_as() const {
    return *reinterpret_cast<Private*>(block + layout->private_offset);
  }
  template <typename Resource>
  const Resource& resource_as() const;
};

/// One packet of an entity and of its sources. Each pose is [components][16].
struct PacketJob {
  int packet = 0;
  const float* const* sources = nullptr;  ///< [source count], in the order of EntityKind::sources
  float* out = nullptr;                   ///< may be one of the sources
};

/// Entities of one layout, one a character, that change the poses of their first sources in place.
struct PosedEntities {
  struct Place {
    std::byte* block;
    std::byte* prepared;
    float* pose;
  };

  std::span<const Place> places;
  EntityInStore alike;   ///< layout and assets, which all have in common
  PoseView poses_alike;  ///< shape of their poses, which all have in common

  std::size_t size() const { return places.size(); }
  EntityInStore entity(std::size_t i) const {
    return {.block = places[i].block, .prepared = places[i].prepared, .layout = alike.layout, .assets = alike.assets};
  }
  PoseView pose(std::size_t i) const {
    PoseView pose = poses_alike;
    pose.first = places[i].pose;
    return pose;
  }
};

/// One packet of the poses of such entities.
struct PacketsJob {
  PosedEntities all;
  int packet = 0;
  std::size_t offset = 0;  ///< floats from the start of each pose to this packet

  float* bones_of(std::size_t i) const { return all.places[i].pose + offset; }
};

/// Tells the scheduler all that it knows of a kind of entity. Kinds of a host's own are treated as ours are.
/// Paper 2.2.6: "Following the formula we can derive various animation tasks that can result in animation states."
///
/// An update calls `advance` once for a run of entities. Then it calls `pose_packet` for each packet in ascending
/// order. A kind that needs bones of several packets at once has `pose_whole` instead, which finds the first source's
/// pose in `pose` and changes it. All functions run on a PU, read the local store and read-only assets alone, and
/// neither allocate nor lock.
struct EntityKind {
  const char* name = "";
  EntityType type = EntityType::user;
  /// Returns the block's sources in the order in which they are read. Null: the kind has none, as a player.
  std::span<Handle> (*sources)(std::byte* block, const EntityLayout& layout) = nullptr;
  /// Size of the private part, behind header and transforms, which updates may change: a fixed number of bytes, and a
  /// number that depends on the pose. Null: the pose adds nothing.
  std::size_t private_bytes = 0;
  std::size_t (*private_bytes_for)(int bone_count, int components) = nullptr;
  /// Its transforms are its own state from update to update, so its blocks are resident under every schedule.
  bool keeps_transforms = false;
  /// Moves the private part's values of each bone to its new index (reorder_lanes.h), between updates. Null: it keeps
  /// nothing by bone.
  void (*reorder_bones)(std::byte* block, const EntityLayout& layout, std::span<const int> places) = nullptr;
  std::size_t prepared_bytes = 0;  ///< a multiple of 64, at most most_prepared_bytes
  /// A function below reads the first line of a transient block (type, size, owner, absolute root). False: that line is
  /// not fetched.
  bool reads_identity = true;
  /// Posing changes nothing in a transient block, so the block is written back as soon as it is advanced.
  bool final_once_advanced = false;

  /// Advances each entity of a run as if it were alone, and says which clips it shows (see advance_each in
  /// entity_run.h). Where the poses of an entity and of all its sources are clips alone, pose_packet is called for none
  /// of them.
  void (*advance)(const EntityRun& run) = nullptr;
  void (*pose_packet)(const EntityInStore& entity, const PacketJob& job) = nullptr;
  void (*pose_whole)(const EntityInStore& entity, const PoseView& pose) = nullptr;  ///< or this one
  /// pose_whole reads and changes bones with smaller numbers than this alone. The others may not be posed yet.
  int whole_bones = std::numeric_limits<int>::max();
  int whole_pose_work = 1;  ///< time of pose_whole as a multiple of a gaze's (CostModel::post_process)
  /// Quads whose positions it changes. Others have the positions of its only source. General skeletons ignore this.
  std::uint64_t displaced_quads = ~std::uint64_t{0};
  /// Does pose_whole for up to widest_strip characters at once. A character's bits do not depend on the others.
  /// Null: pose_whole is called for each.
  void (*pose_strip)(const PosedEntities& all) = nullptr;
  /// Does pose_packet for up to widest_strip characters at once, in place.
  void (*pose_packets)(const PacketsJob& job) = nullptr;

  const void* resource = nullptr;  ///< read-only data of the kind for this skeleton, which outlives the pools

  bool whole_pose() const { return pose_whole != nullptr; }
};

inline std::size_t EntityLayout::unread_bytes() const {
  return is_resident() || kind->reads_identity ? 0 : identity_bytes;
}

inline bool EntityLayout::final_once_advanced() const { return kind->final_once_advanced && !is_resident(); }

template <typename Resource>
const Resource& EntityInStore::resource_as() const {
  return *static_cast<const Resource*>(layout->kind->resource);
}

/// EntityKind::sources for an entity that reads one state, its member `source`.
template <typename Entity>
std::span<Handle> only_source(std::byte* block, const EntityLayout&) {
  return {&reinterpret_cast<Entity*>(block)->source, 1};
}

/// EntityKind::pose_whole for a kind that has pose_strip: calls it for one character.
template <void (*pose_strip)(const PosedEntities& all)>
void pose_alone(const EntityInStore& entity, const PoseView& pose) {
  const PosedEntities::Place place{.block = entity.block, .prepared = entity.prepared, .pose = pose.first};
  pose_strip({.places = {&place, 1}, .alike = entity, .poses_alike = pose});
}

/// Gives the entity its source's velocity.
inline void take_velocity(AnimationStateHeader& state, const AnimationStateHeader& source) {
  std::ranges::copy(source.linear_velocity, state.linear_velocity);
  std::ranges::copy(source.angular_velocity, state.angular_velocity);
}

inline constexpr std::size_t max_sources = 8;
inline constexpr std::size_t most_prepared_bytes = 256;

}  // namespace throng::anim
