#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "engine/anim/agent/weighted_process.h"
#include "engine/anim/entity/chain_reach_entity.h"
#include "engine/anim/entity/ik_entity.h"
#include "engine/anim/entity/look_at_entity.h"

/// The processes that turn a body, a limb or a chain towards a place.
namespace throng::anim {

/// A weighted process whose entity has a `target`: a place in metres in the character's model space.
template <typename Entity>
class TargetedProcess : public WeightedProcess<Entity> {
 public:
  /// Sets the target at once, from the next update on. A caller that wants a slow change moves it slowly.
  void set_target(const glm::vec3& target, const char* call = "Processes::reach") {
    if (all_finite(target)) {
      target_ = target;
    } else {
      report_misuse({call, "a target is of finite numbers"});
    }
  }

 protected:
  TargetedProcess(EntityPools::Kind kind, const glm::vec3& target)
      : WeightedProcess<Entity>(kind, 0.0F), target_(target) {}

 private:
  void write(const EntityBuilder& build, Handle entity) const final {
    for (int axis = 0; axis < 3; ++axis) build.as<Entity>(entity).target[axis] = target_[axis];
  }

  glm::vec3 target_;
};

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

/// Lets any chain of bones, such as a tail or a spine, reach for a place. Its weight is 0 until it is set.
class ChainReachProcess final : public TargetedProcess<ChainReachEntity> {
 public:
  struct Settings {
    std::uint32_t chain = 0;  ///< index into the chains of the kind
    int iterations = 16;      ///< see ChainReachJob
    float tolerance = 1e-3F;
  };
  /// `kind` is what Characters::add_entity_kind returned for chain_reach_kind(chains).
  explicit ChainReachProcess(EntityPools::Kind kind, const Settings& settings)
      : TargetedProcess(kind, {0.0F, 0.0F, 0.0F}), settings_(settings) {}

  /// Returns the metres from the end of the chain to the target at the last update.
  float missed_by(const EntityPools& pools) const {
    return entity().valid() ? pools.private_as<ChainReachMemory>(entity()).missed_by : 0.0F;
  }

  const char* fault(const EntityBuilder& build) const override {
    if (const char* const no_kind = TargetedProcess::fault(build); no_kind != nullptr) return no_kind;
    if (settings_.chain >= resource<std::vector<ReachChain>>(build).size())
      return "chain is not one of the kind's chains";
    const bool ends = settings_.iterations >= 1 && settings_.iterations <= most_reach_iterations;
    return ends && settings_.tolerance >= 0.0F ? nullptr : "iterations are from 1 to 64, and tolerance is not negative";
  }
  std::unique_ptr<PostProcess> clone() const override { return std::make_unique<ChainReachProcess>(*this); }

 private:
  void begin_private(const EntityBuilder& build, Handle reach) const override {
    build.private_as<ChainReachMemory>(reach) = {.chain = settings_.chain,
                                                 .iterations = settings_.iterations,
                                                 .tolerance = settings_.tolerance,
                                                 .missed_by = 0.0F};
  }

  Settings settings_;
};

}  // namespace throng::anim
