#pragma once

#include <vector>

#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/entity/ease_blender.h"
#include "engine/anim/entity/entity_pools.h"
#include "engine/anim/entity/held_state.h"

namespace throng::anim {

/// Entities of one skeleton in resident blocks, updated one after the other in plain sight: what any schedule must
/// give.
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

  /// A state in which every bone is turned by `radians` about z and `metres` along x.
  Handle held(float radians, float metres = 0.0F);
  void set_pose(Handle held, float radians, float metres = 0.0F);

  /// An ease blender that stands still.
  Handle hold(Handle from, Handle to, float fraction);

  /// Bones at and above `first` weigh 1, those below 0. The index for the entities' masks.
  std::int16_t mask_from(int first);

  /// Every entity that `root` reads, then `root`; the first packets alone at a coarser level of detail.
  void update(Handle root, Ticks delta, int packets = packets_for(bones));

  PoseView pose(Handle entity);
  float angle(Handle entity, int bone);  ///< about z
  float place(Handle entity, int bone);  ///< along x
  std::vector<float> floats(Handle entity);

 private:
  EntityPools pools_;
  std::vector<AlignedBytes> masks_;
  std::vector<const float*> mask_list_;
  EntityAssets assets_;
};

}  // namespace throng::anim
