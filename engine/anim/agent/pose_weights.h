#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "engine/anim/entity/entity_pools.h"
#include "engine/anim/run/program/pose_program.h"

namespace throng::anim {

/// The weights of the steps of a program, in their order.
using PoseWeights = std::array<float, PoseProgram::max_steps>;

/// The least and the largest weight that a mask gives a bone.
struct MaskRange {
  float least = 0.0F;
  float most = 1.0F;
};

/// Holds the data by which the weights of morphs and of data keys are blended.
struct MorphBlend {
  std::span<const int> bones{};           ///< of each morph, the bone at which masks count for it
  std::span<const float* const> masks{};  ///< each [bone]
  std::span<const MaskRange> ranges{};    ///< of each mask
};

/// Shares out the weight of a pose among its steps. The root has all of it; blenders and mixers pass
/// it on to their sources.
class PoseSharing {
 public:
  /// Says for what part of the agent the weights are.
  enum class Part : unsigned char {
    motion,   ///< the agent's own motion, which knows no masks: a masked or additive layer has no share
    bone,     ///< one bone
    anywhere  ///< the bone in which the step weighs most; below several masks it is the product of the largest weights
  };

  /// `since_posed` is the time by which fades have moved on since the blocks were updated.
  PoseSharing(const EntityPools& pools, const PoseGraph& graph, const MorphBlend& masks, Ticks since_posed)
      : pools_(&pools), graph_(&graph), masks_(&masks), since_posed_(since_posed) {}

  /// `bone` is read for Part::bone.
  PoseWeights weights(Part part, int bone = 0) const;

 private:
  struct Asked {
    Part part;
    int bone;
  };
  MaskRange mask_at(const Asked& asked, std::int16_t mask) const;
  void share(const Asked& asked, std::size_t step, PoseWeights& weights) const;
  void share_blended(const Asked& asked, std::size_t step, PoseWeights& weights) const;
  void share_mixed(const Asked& asked, std::size_t step, PoseWeights& weights) const;
  void share_layered(const Asked& asked, std::size_t step, PoseWeights& weights) const;

  const EntityPools* pools_;
  const PoseGraph* graph_;
  const MorphBlend* masks_;
  Ticks since_posed_;
};

}  // namespace throng::anim
