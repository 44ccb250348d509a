#pragma once

#include <vector>

#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/entity/ease_blender.h"
#include "engine/anim/entity/entity_pools.h"
#include "engine/anim/entity/held_state.h"

namespace throng::anim {

/// Entities of one skeleton in resident blocks, updated one after the other in plain sight. Any schedule must give the
/// same.
class EntityRig {
 public:
  static constexpr int bones = 20;  ///< two packets, the second one partly filled

  explicit EntityRig(std::span<const ClipStreams> clips = {});

  EntityPools& pools() { return pools_; }
  Handle create(EntityPools::Kind kind, std::uint32_t owner = 0);
  template <typename Entity>
  Entity& as(Handle entity) {
    return pools_.as<Entity>(entity);
  }

  /// Makes a state in which every bone is turned by `radians` about z and moved by `metres` along x.
  Handle held(float radians, float metres = 0.0F);
  void set_pose(Handle held, float radians, float metres = 0.0F);

  /// Makes an ease blender that stands still.
  Handle hold(Handle from, Handle to, float fraction);

  /// Makes a mask in which bones at and above `first` weigh 1, and those below 0. Returns the index for the entities'
  /// masks.
  std::int16_t mask_from(int first);

  /// Updates every entity that `root` reads, then `root`. A coarser level of detail has only the first `packets`.
  void update(Handle root, Ticks delta, int packets = packets_for(bones));

  PoseView pose(Handle entity);
  float angle(Handle entity, int bone);  ///< the angle about z
  float place(Handle entity, int bone);  ///< the place along x
  std::vector<float> floats(Handle entity);

 private:
  EntityPools pools_;
  std::vector<AlignedBytes> masks_;
  std::vector<const float*> mask_list_;
  EntityAssets assets_;
};

}  // namespace throng::anim
