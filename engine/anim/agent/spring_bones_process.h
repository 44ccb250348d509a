#pragma once

#include <algorithm>
#include <cstdint>

#include "engine/anim/agent/weighted_process.h"
#include "engine/anim/entity/spring_bones_entity.h"
#include "engine/anim/kernel/lanes/rotations.h"

namespace throng::anim {

/// Lets hair, skirts and tails follow the body on springs. The host says where the character stands, so that they feel
/// its movement through the world.
class SpringBonesProcess final : public WeightedProcess<SpringBonesEntity> {
 public:
  /// `kind` is what Characters::add_entity_kind returned for spring_bones_kind(rig).
  explicit SpringBonesProcess(EntityPools::Kind kind) : WeightedProcess(kind, 1.0F) {}

  /// Sets where model space is in the world.
  void set_placement(const JointMotion& model_in_world) {
    if (is_valid(model_in_world)) {
      model_in_world_ = model_in_world;
    } else {
      report_misuse({"Processes::set_placement", not_a_placement});
    }
  }
  /// Sets the height that no bone falls below, in world space. There is none until it is set.
  void set_ground(float height) {
    if (height < farthest_place) {
      ground_ = height;
    } else {
      report_misuse({"SpringBonesProcess::set_ground", "a height is a number of metres"});
    }
  }
  /// Starts anew at the next update, at rest in the pose: after a cut, or when the character was put elsewhere.
  void restart() { ++restarts_; }

  /// Returns the ends of the bones that swing at the last update, in world space and in the order of SpringRig::joints.
  /// There are none before the agent is posed.
  std::span<const SpringJointState> joints(const EntityPools& pools) const {
    if (!entity().valid()) return {};
    return spring_joints(rig_of(pools), pools.private_as<SpringBody>(entity()));
  }

  std::unique_ptr<PostProcess> clone() const override { return std::make_unique<SpringBonesProcess>(*this); }

 private:
  void begin_private(const EntityBuilder& build, Handle springs) const override {
    auto& body = build.private_as<SpringBody>(springs);
    body = {};
    std::ranges::fill(spring_carriers(rig_of(build.pools()), body), JointMotion{});
    std::ranges::fill(spring_joints(rig_of(build.pools()), body), SpringJointState{});
  }
  void write(const EntityBuilder& build, Handle springs) const override {
    auto& body = build.private_as<SpringBody>(springs);
    body.model_in_world = model_in_world_;
    body.ground = ground_;
    body.restarts = restarts_;
  }

  const SpringRig& rig_of(const EntityPools& pools) const {
    return *static_cast<const SpringRig*>(pools.kind(entity()).resource);
  }

  JointMotion model_in_world_;
  float ground_ = -std::numeric_limits<float>::infinity();
  std::uint32_t restarts_ = 0;
};

}  // namespace throng::anim
