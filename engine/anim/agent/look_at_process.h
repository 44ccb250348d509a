#pragma once

#include "engine/anim/agent/weighted_process.h"
#include "engine/anim/entity/look_at_entity.h"

namespace throng::anim {

/// Turns spine, neck and head towards a target, within limits. It looks nowhere until look_at().
class LookAtProcess final : public TargetedProcess<LookAtEntity> {
 public:
  /// `kind` is RigKinds::look_at.
  explicit LookAtProcess(EntityPools::Kind kind, const LookAtLimits& limits = {})
      : TargetedProcess(kind, {0.0F, 0.0F, 1.0F}), limits_(limits) {}

  /// Sets the target, and fades to the full weight if it looked away.
  void look_at(const glm::vec3& target, Ticks fade = {}) {
    set_target(target, "Processes::look_at");
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

  const char* fault(const EntityBuilder& build) const override {
    if (!is_valid(limits_)) return "the limits of a gaze are angles: yaw below half a turn, pitch below a quarter";
    return TargetedProcess::fault(build);
  }
  std::unique_ptr<PostProcess> clone() const override { return std::make_unique<LookAtProcess>(*this); }

 private:
  void begin_private(const EntityBuilder& build, Handle look) const override {
    build.private_as<LookAtMemory>(look) = {.limits = limits_, .gaze = {}};
  }

  LookAtLimits limits_;
  bool looks_ = false;
};

}  // namespace throng::anim
