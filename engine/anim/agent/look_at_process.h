#pragma once

#include "engine/anim/agent/weighted_process.h"
#include "engine/anim/entity/look_at_entity.h"

namespace throng::anim {

/// Looks at something: spine, neck and head turn towards it, within limits. Looks nowhere until it is told to.
class LookAtProcess final : public WeightedProcess<LookAtEntity> {
 public:
  /// `kind`: RigKinds::look_at.
  explicit LookAtProcess(EntityPools::Kind kind, const LookAtLimits& limits = {})
      : WeightedProcess(kind, 0.0F), limits_(limits) {}

  /// Metres, model space: the character's own. From the next update on; how fast the head turns is in the limits.
  void set_target(const glm::vec3& target) { target_ = target; }
  /// The target, and all of the weight.
  void look_at(const glm::vec3& target, Ticks fade = 0) {
    set_target(target);
    if (!std::exchange(looks_, true)) set_weight(1.0F, fade);
  }
  /// Back to where the animation looks.
  void look_away(Ticks fade) {
    if (std::exchange(looks_, false)) set_weight(0.0F, fade);
  }

  /// Radians between gaze and target at the last update.
  float remaining(const EntityPools& pools) const {
    return entity().valid() ? pools.private_as<LookAtMemory>(entity()).gaze.remaining : 0.0F;
  }

  std::unique_ptr<PostProcess> clone() const override { return std::make_unique<LookAtProcess>(*this); }

 private:
  void begin_private(const EntityBuilder& build, Handle look) const override {
    build.private_as<LookAtMemory>(look) = {.limits = limits_, .gaze = {}};
  }
  void write(const EntityBuilder& build, Handle look) const override {
    for (int axis = 0; axis < 3; ++axis) build.as<LookAtEntity>(look).target[axis] = target_[axis];
  }

  LookAtLimits limits_;
  glm::vec3 target_{0.0F, 0.0F, 1.0F};
  bool looks_ = false;
};

}  // namespace throng::anim
