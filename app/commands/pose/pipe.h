#pragma once

#include <memory>

#include "app/commands/pose/dump.h"
#include "engine/anim/agent/animation_system.h"

namespace throng::app {

/// Computes poses as the crowd does: a player's block on a PU with its local store, the kernels, a palette slot. It has
/// one agent, in the paper's `levels` schedule, whose blocks keep their transforms.
class PosePipe {
 public:
  explicit PosePipe(anim::StreamKind stream) : stream_(stream) {}

  /// Returns the pose at `seconds`. `clip` is a clip of the model, or null for the rest pose.
  Result<BonePose> pose(const anim::Model& model, const anim::Clip* clip, double seconds);

 private:
  Status prepare(const anim::Model& model, const anim::Clip* clip);

  anim::StreamKind stream_;
  const anim::Model* model_ = nullptr;  // the model that `system_` was made for
  const anim::Clip* clip_ = nullptr;
  std::unique_ptr<anim::AnimationSystem> system_;
  anim::AlignedBytes palette_;
};

}  // namespace throng::app
