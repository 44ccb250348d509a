// What kinds that tweak whole poses say that they read and change is all that they do.

#include <array>
#include <functional>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/entity/entity_layout.h"
#include "engine/anim/entity/foot_placement_entity.h"
#include "engine/anim/entity/ik_entity.h"
#include "engine/anim/entity/look_at_entity.h"
#include "engine/anim/entity/whole_pose_step.h"
#include "tests/anim/kernel/pose/held_pose.h"
#include "tests/anim/rig/named_skeleton.h"

namespace throng::anim::whole_pose_kinds_test {
namespace {

constexpr FadingWeight whole_weight{.from = 1.0F, .to = 1.0F, .elapsed = 0.0F, .total = 0.0F};

/// Twenty bones, and a tail of thirty that nobody asks about.
std::vector<NamedJoint> person_with_a_tail() {
  std::vector<NamedJoint> joints = person_joints();
  for (int i = 0; i < 30; ++i) {
    const std::string parent = i == 0 ? "root" : joints.back().name;
    joints.push_back({"tail." + std::to_string(i), parent, {0.0F, 1.0F, -0.1F * static_cast<float>(i)}});
  }
  return joints;
}

/// A kind, and how an entity of it is told to do something.
struct ToldKind {
  EntityKind kind;
  std::function<void(const EntityInStore& entity)> tell;
};

class WholePoseKinds : public testing::Test {
 protected:
  int bone(const char* name) const { return find_bone(skeleton_, name); }

  std::array<ToldKind, 3> kinds() const {
    const auto feet = [](const EntityInStore& entity) {
      entity.as<FootPlacementEntity>().weight = whole_weight;
      auto& memory = entity.private_as<FootPlacementMemory>();
      memory.body = {};
      for (PlacedFoot& foot : feet_of(*entity.layout->kind, memory)) {
        foot = {.ground = {.place = {0.0F, -0.1F, 0.0F}}, .planted = 1.0F};
      }
    };
    const auto gaze = [](const EntityInStore& entity) {
      auto& look = entity.as<LookAtEntity>();
      look.weight = whole_weight;
      look.target[0] = 1.0F;
      look.target[2] = 0.5F;
      entity.private_as<LookAtMemory>() = {};
    };
    const auto reach = [](const EntityInStore& entity) {
      auto& ik = entity.as<IkEntity>();
      ik.weight = whole_weight;
      ik.target[1] = 1.0F;
      ik.target[2] = 0.4F;
      entity.private_as<IkMemory>().limb = 1;
    };
    return {{{foot_placement_kind(feet_), feet}, {look_at_kind(gaze_), gaze}, {ik_kind(limbs_), reach}}};
  }

  /// Once, for one character.
  void pose(const ToldKind& told, HeldPose& pose) const {
    const EntityLayout layout =
        entity_layout(told.kind, Residency::transient, skeleton_.bone_count(), rigid_components);
    const AlignedBytes block = allocate_aligned(layout.total_size);
    const AlignedBytes prepared = allocate_aligned(whole_pose_prepared_bytes);
    const EntityAssets assets{.kernels = &best_kernels(), .bone_count = skeleton_.bone_count()};
    const EntityInStore entity{block.get(), prepared.get(), &layout, &assets};
    told.tell(entity);
    entity.prepared_as<WholePoseStep>() = {.seconds = 0.1F};
    told.kind.pose_whole(entity, pose.view());
  }

  HeldPose shaken() const {
    std::mt19937 random(3);
    HeldPose pose(skeleton_);
    pose.shake(random, 0.2F);
    return pose;
  }

  Skeleton skeleton_ = named_skeleton(person_with_a_tail());
  LookAtRig gaze_ = make_look_at_rig(skeleton_, std::array{LookBone{bone("neck")}, LookBone{bone("head")}}).value();
  FootPlacementRig feet_ =
      make_foot_placement_rig(skeleton_,
                              std::array{LegBones{bone("thigh.L"), bone("shin.L"), bone("foot.L"), bone("toe.L")},
                                         LegBones{bone("thigh.R"), bone("shin.R"), bone("foot.R"), bone("toe.R")}})
          .value();
  std::vector<TwoBoneLimb> limbs_{
      make_two_bone_limb(skeleton_, bone("upper_arm.L"), bone("forearm.L"), bone("hand.L"), {0, 0, -1}).value(),
      make_two_bone_limb(skeleton_, bone("upper_arm.R"), bone("forearm.R"), bone("hand.R"), {0, 0, -1}).value()};
};

TEST_F(WholePoseKinds, DoTheirPartWhereOnlyTheBonesAreThereThatTheyAskFor) {
  for (const ToldKind& told : kinds()) {
    SCOPED_TRACE(told.kind.name);
    const int there = packets_for(told.kind.whole_bones) * packet_bones;
    ASSERT_LT(there, skeleton_.bone_count());
    HeldPose whole = shaken();
    HeldPose part = shaken();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (int bone = there; bone < skeleton_.bone_count(); ++bone) {
      part.view().set_rotation(bone, {nan, nan, nan, nan});
      part.view().set_position(bone, glm::vec3(nan));
    }
    pose(told, whole);
    pose(told, part);
    EXPECT_NE(whole.floats(), shaken().floats());
    for (int bone = 0; bone < there; ++bone) {
      EXPECT_EQ(part.view().rotation(bone), whole.view().rotation(bone)) << bone;
    }
    for (int bone = told.kind.whole_bones; bone < skeleton_.bone_count(); ++bone) {
      EXPECT_EQ(whole.view().rotation(bone), shaken().view().rotation(bone)) << bone;
    }
  }
}

TEST_F(WholePoseKinds, DisplaceNoBonesButThoseOfTheQuadsThatTheyName) {
  for (const ToldKind& told : kinds()) {
    SCOPED_TRACE(told.kind.name);
    HeldPose before = shaken();
    HeldPose after = shaken();
    pose(told, after);
    std::uint64_t displaced = 0;
    for (int bone = 0; bone < skeleton_.bone_count(); ++bone) {
      if (after.view().position(bone) != before.view().position(bone)) displaced |= quads_with(bone);
    }
    EXPECT_EQ(displaced, told.kind.displaced_quads);
  }
}

}  // namespace
}  // namespace throng::anim::whole_pose_kinds_test
