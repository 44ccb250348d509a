#pragma once

#include "engine/anim/agent/weighted_process.h"
#include "engine/anim/entity/ik_entity.h"

namespace throng::anim {

/// Lets a hand or a foot reach for a place, by two-bone IK. Its weight is 0 until it is set.
class ReachProcess final : public TargetedProcess<IkEntity> {
 public:
  struct Settings {
    std::uint32_t limb = 0;   ///< CharacterRigs::limb
    float softness = 0.005F;  ///< see TwoBoneIkJob
    glm::vec3 pole{0.0F};     ///< model space: where the elbow or knee must point; zero keeps the pose's
  };
  /// `kind` is RigKinds::limbs.
  ReachProcess(EntityPools::Kind kind, const Settings& settings)
      : TargetedProcess(kind, {0.0F, 0.0F, 0.0F}), settings_(settings) {}

  /// Returns the metres from the end of the limb to the target at the last update.
  float missed_by(const EntityPools& pools) const {
    return entity().valid() ? pools.private_as<IkMemory>(entity()).missed_by : 0.0F;
  }

  const char* fault(const EntityBuilder& build) const override {
    if (const char* const no_kind = TargetedProcess::fault(build); no_kind != nullptr) return no_kind;
    if (settings_.limb >= resource<std::vector<TwoBoneLimb>>(build).size())
      return "limb is not one of the kind's limbs";
    const bool is_share = settings_.softness >= 0.0F && settings_.softness <= most_limb_softness;
    return is_share && all_finite(settings_.pole) ? nullptr : "softness is from 0 to 0.5, and a pole of finite numbers";
  }
  std::unique_ptr<PostProcess> clone() const override { return std::make_unique<ReachProcess>(*this); }

 private:
  void begin_private(const EntityBuilder& build, Handle ik) const override {
    build.private_as<IkMemory>(ik) = {.limb = settings_.limb,
                                      .softness = settings_.softness,
                                      .pole = settings_.pole,
                                      .end_rotation = {1.0F, 0.0F, 0.0F, 0.0F},
                                      .turn_end = false,
                                      .missed_by = 0.0F};
  }

  Settings settings_;
};

}  // namespace throng::anim
