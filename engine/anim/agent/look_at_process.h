#pragma once

#include "engine/anim/agent/weighted_process.h"
#include "engine/anim/entity/look_at_entity.h"

namespace throng::anim {

/// Turns spine, neck and head towards something, within limits. It looks nowhere until it is told to.
class LookAtProcess final : public WeightedProcess<LookAtEntity> {
 public:
  /// `kind` is RigKinds::look_at.
  explicit LookAtProcess(EntityPools::Kind kind, const LookAtLimits& limits = {})
      : WeightedProcess(kind, 0.0F), limits_(limits) {}

  /// Sets the target from the next update on, in metres in the character's model space. The limits say how fast the
  /// head turns.
  void set_target(const glm::vec3& target) {
    if (all_finite(target)) {
      target_ = target;
    } else {
      report_misuse({"LookAtProcess::set_target", "a target is of finite numbers"});
    }
  }
  /// Sets the target, and fades to the full weight if it looked away.
  void look_at(const glm::vec3& target, Ticks fade = {}) {
    set_target(target);
    if (!std::exchange(looks_, true)) set_weight(1.0F, fade);
  }
  /// Fades back to where the animation looks.
  void look_away(Ticks fade) {
    if (std::exchange(looks_, false)) set_weight(0.0F, fade);
  }

  /// Returns the radians between gaze and target at the last update.
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
