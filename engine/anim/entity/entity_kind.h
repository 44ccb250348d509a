#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "engine/anim/asset/bone_priorities.h"
#include "engine/anim/base/pool.h"
#include "engine/anim/entity/animation_state.h"
#include "engine/anim/kernel/kernels.h"
#include "engine/anim/kernel/pose/pose_view.h"

namespace throng::anim {

struct ClipStreams;
struct EntityKind;
struct EntityRun;

enum class Residency : std::uint8_t { transient, resident };

/// Where the parts of an entity's block lie (drawn in animation_state.h).
struct EntityLayout {
  const EntityKind* kind = nullptr;
  std::uint32_t total_size = 0;
  std::uint32_t transforms_offset = 0;  ///< 0: transient
  std::uint32_t private_offset = 0;     ///< == total_size where there is no private part

  bool is_resident() const { return transforms_offset != 0; }
  /// Bytes that a source costs to fetch: header and transforms, without the private part.
  std::uint32_t source_bytes() const { return private_offset; }
  std::uint32_t private_bytes() const { return total_size - private_offset; }
  /// First bytes of a block that nobody reads in the local store, and that are not fetched.
  std::size_t unread_bytes() const;
  bool final_once_advanced() const;
};

/// Read-only memory that entities of one skeleton may read beside their own block.
struct EntityAssets {
  std::span<const ClipStreams> clips{};
  std::span<const float* const> masks{};  ///< each [packets][16]
  std::span<const BoneSelection> selections{};
  const Kernels* kernels = nullptr;
  int bone_count = 0;
  int components = rigid_components;
  bool prefetch = false;  ///< of streams, before the first packet

  const float* mask(std::int16_t index) const { return index < 0 ? nullptr : masks[static_cast<std::size_t>(index)]; }
};

/// An entity while it lies in the local store.
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

/// 16 bones of an entity and its sources, each [components][16].
struct PacketJob {
  int packet = 0;
  const float* const* sources = nullptr;  ///< [source count], in the order of EntityKind::sources
  float* out = nullptr;                   ///< may be one of the sources
};

/// Entities of one layout, each of another character, and the poses of their first sources, which they change.
struct PosedEntities {
  struct Place {
    std::byte* block;
    std::byte* prepared;
    float* pose;
  };

  std::span<const Place> places;
  EntityInStore alike;   ///< what all have in common, but for places
  PoseView poses_alike;  ///< the same of their poses

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

/// 16 bones of such poses.
struct PacketsJob {
  PosedEntities all;
  int packet = 0;
  std::size_t offset = 0;  ///< floats, to where these bones lie in each pose

  float* bones_of(std::size_t i) const { return all.places[i].pose + offset; }
};

/// Paper 2.2.6: "Following the formula we can derive various animation tasks that can result in animation states." What
/// the scheduler must know of a kind of entity; a user's own kinds are told apart from ours by nothing.
///
/// An update of an entity is one call of `advance`, for a run of them at once, then either `pose_packet` for each
/// packet in ascending order or, for what needs bones of several packets at once, `pose_whole` with the pose of the
/// first source in `pose`. All run on a PU, see only the local store and read-only assets, and neither allocate nor
/// lock.
struct EntityKind {
  const char* name = "";
  EntityType type = EntityType::user;
  /// The block's sources, to be read in this order; null: none, as a player.
  std::span<Handle> (*sources)(std::byte* block, const EntityLayout& layout) = nullptr;
  /// Behind header and transforms; changed by updates: what the kind asks for, and what poses of this size do. Null:
  /// nothing.
  std::size_t private_bytes = 0;
  std::size_t (*private_bytes_for)(int bone_count, int components) = nullptr;
  /// Its transforms are state of its own, kept from update to update: resident under every schedule.
  bool keeps_transforms = false;
  std::size_t prepared_bytes = 0;  ///< a multiple of 64, at most most_prepared_bytes
  /// Of a transient block: its first line, which says what its pool says too, whose it is and where it begins. False:
  /// no function below reads it, and it is not fetched.
  bool reads_identity = true;
  /// Posing changes nothing of a transient block: it goes back to main memory as soon as it is advanced.
  bool final_once_advanced = false;

  /// Each of a run as if it were alone, and what it shows (entity_run.h: advance_each). Where its pose is clips, as
  /// those of all its sources are, neither its pose_packet is called nor theirs.
  void (*advance)(const EntityRun& run) = nullptr;
  void (*pose_packet)(const EntityInStore& entity, const PacketJob& job) = nullptr;
  void (*pose_whole)(const EntityInStore& entity, const PoseView& pose) = nullptr;  ///< or this one
  /// pose_whole reads and changes the bones below this one alone: the others need not be there yet.
  int whole_bones = std::numeric_limits<int>::max();
  int whole_pose_work = 1;  ///< what pose_whole takes, in gazes: CostModel::post_process
  /// Positions of the bones of other quads are those of its only source. On general skeletons all are displaced.
  std::uint64_t displaced_quads = ~std::uint64_t{0};
  /// For up to widest_strip characters at once, each as pose_whole would, to the bit and whoever the others are; called
  /// where these stand side by side. Null: pose_whole is called for each.
  void (*pose_strip)(const PosedEntities& all) = nullptr;
  /// The same of pose_packet, where it changes bones where they lie.
  void (*pose_packets)(const PacketsJob& job) = nullptr;

  const void* resource = nullptr;  ///< read-only data of the kind on this skeleton; outlives the pools

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

/// EntityKind::sources of an entity that reads one state, its `source`.
template <typename Entity>
std::span<Handle> only_source(std::byte* block, const EntityLayout&) {
  return {&reinterpret_cast<Entity*>(block)->source, 1};
}

/// EntityKind::pose_whole where pose_strip does it for one as for many.
template <void (*pose_strip)(const PosedEntities& all)>
void pose_alone(const EntityInStore& entity, const PoseView& pose) {
  const PosedEntities::Place place{.block = entity.block, .prepared = entity.prepared, .pose = pose.first};
  pose_strip({.places = {&place, 1}, .alike = entity, .poses_alike = pose});
}

/// The entity moves as its source does.
inline void take_velocity(AnimationStateHeader& state, const AnimationStateHeader& source) {
  std::ranges::copy(source.linear_velocity, state.linear_velocity);
  std::ranges::copy(source.angular_velocity, state.angular_velocity);
}

inline constexpr std::size_t max_sources = 8;
inline constexpr std::size_t most_prepared_bytes = 256;

}  // namespace throng::anim
