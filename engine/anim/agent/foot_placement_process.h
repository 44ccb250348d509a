#pragma once

#include <array>

#include "engine/anim/agent/weighted_process.h"
#include "engine/anim/entity/foot_placement_entity.h"

namespace throng::anim {

/// The reason why a ground is refused.
inline constexpr const char* not_a_ground = "a leg is one of the rig, and the unit normal of its ground faces up";

/// Lets feet stand on the ground. The host says where the character stands and, for each leg, on which
/// plane. Planes are in world space, so that they stay true while the character walks over them.
///
/// On uneven ground, sample it under `ankle(leg)` at each frame boundary, where the ankle was at the last update. The
/// plane is then taken under the ankle as it is posed. This is exact on flat ground and slopes; elsewhere it is off by
/// the bend of the ground in one update.
class FootPlacementProcess final : public WeightedProcess<FootPlacementEntity> {
 public:
  /// `kind` is RigKinds::foot_placement. The ground is flat at height 0 until told otherwise.
  explicit FootPlacementProcess(EntityPools::Kind kind, const FootPlacementOptions& options = {})
      : WeightedProcess(kind, 1.0F), options_(options) {
    planted_.fill(planted_by_pose);
  }

  /// Sets where model space is in the world, turned about the vertical only.
  void set_placement(const JointMotion& model_in_world) {
    if (is_valid(model_in_world)) {
      model_in_world_ = model_in_world;
    } else {
      report_misuse({"Processes::set_placement", not_a_placement});
    }
  }
  /// Sets the plane of one leg: a point of it and its unit normal (y above 0), in world space.
  void set_ground(int leg, const Footing& plane) {
    if (leg >= 0 && leg < max_legs && is_valid(plane)) {
      ground_[static_cast<std::size_t>(leg)] = plane;
    } else {
      report_misuse({"Processes::set_ground", not_a_ground});
    }
  }
  /// Sets the plane of all legs.
  void set_ground(const Footing& plane) {
    for (int leg = 0; leg < max_legs; ++leg) set_ground(leg, plane);
  }
  /// Sets how far a foot is planted, 0 (in the air) to 1 (on the ground), or planted_by_pose, which goes by the height
  /// at which the pose has the sole.
  void set_planted(int leg, float planted) {
    if (leg >= 0 && leg < max_legs && (planted == planted_by_pose || (planted >= 0.0F && planted <= 1.0F))) {
      planted_[static_cast<std::size_t>(leg)] = planted;
    } else {
      report_misuse({"FootPlacementProcess::set_planted", "a leg is one of the rig, and planted from 0 to 1"});
    }
  }

  /// Returns the ankle of a leg at the last update, as the animation has it before it is placed, in world space. Like
  /// what follows, it is 0 before the agent is posed, and for a leg that there is not.
  glm::vec3 ankle(const EntityPools& pools, int leg) const {
    if (!has(pools, leg)) return glm::vec3(0.0F);
    const auto& memory = pools.private_as<FootPlacementMemory>(entity());
    const JointMotion& model = memory.body.model_in_world;
    return model.position + model.rotation * memory.feet[leg].ankle;
  }
  /// Returns the metres by which the pelvis was lowered at the last update.
  float drop(const EntityPools& pools) const {
    return entity().valid() ? pools.as<FootPlacementEntity>(entity()).drop : 0.0F;
  }
  const FootLock& lock(const EntityPools& pools, int leg) const {
    static constexpr FootLock free{};
    return has(pools, leg) ? pools.private_as<FootPlacementMemory>(entity()).feet[leg].lock : free;
  }

  const char* fault(const EntityBuilder& build) const override {
    if (!is_valid(options_)) return "the options of feet are metres and seconds, none of them negative";
    return WeightedProcess::fault(build);
  }
  std::unique_ptr<PostProcess> clone() const override { return std::make_unique<FootPlacementProcess>(*this); }

 private:
  bool has(const EntityPools& pools, int leg) const {
    if (!entity().valid() || leg < 0) return false;
    return leg < static_cast<const FootPlacementRig*>(pools.kind(entity()).resource)->leg_count;
  }
  void begin_private(const EntityBuilder& build, Handle feet) const override {
    build.private_as<FootPlacementMemory>(feet).body = {.options = options_};
    std::ranges::fill(feet_at(build, feet), PlacedFoot{});
  }
  void write(const EntityBuilder& build, Handle feet) const override {
    build.private_as<FootPlacementMemory>(feet).body.model_in_world = model_in_world_;
    for (std::size_t leg = 0; PlacedFoot & foot : feet_at(build, feet)) {
      foot.ground = ground_[leg];
      foot.planted = planted_[leg++];
    }
  }

  static std::span<PlacedFoot> feet_at(const EntityBuilder& build, Handle feet) {
    return feet_of(build.pools().kind(feet), build.private_as<FootPlacementMemory>(feet));
  }

  FootPlacementOptions options_;
  std::array<Footing, max_legs> ground_{};
  std::array<float, max_legs> planted_{};
  JointMotion model_in_world_;
};

}  // namespace throng::anim
