#include <algorithm>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/anim/kernel/ragdoll/ragdoll_stage.h"

namespace throng::anim::ragdoll_pose_test {
namespace {

using namespace ragdoll_stage;

class RagdollPose : public testing::Test {
 protected:
  /// Arms and legs bent, the trunk leaning, the pelvis lowered.
  Pose bent() const {
    Pose pose(model_.skeleton.bone_count());
    for (const RagdollBody& body : rig_.bodies) {
      const float angle = 0.1F + 0.03F * static_cast<float>(body.bone);
      pose.view().set_rotation(body.bone, glm::angleAxis(angle, glm::normalize(glm::vec3(1.0F, 0.3F, -0.2F))));
    }
    pose.view().set_position(rig_.bodies[0].bone, {0.1F, -0.2F, 0.3F});
    return pose;
  }

  Model model_ = person();
  RagdollRig rig_ = rig_of(model_);
};

TEST_F(RagdollPose, ComesBackAsItWasTakenOver) {
  Pose pose = bent();
  RagdollState state;
  ragdoll_from_pose(rig_, {.before = pose.view(), .now = pose.view()}, state);
  const auto expected = bone_origins(model_.skeleton, pose.view());
  const auto actual = bone_origins(model_, rig_, state);
  for (std::size_t bone = 0; bone < expected.size(); ++bone) {
    EXPECT_LT(glm::distance(actual[bone], expected[bone]), 1e-5) << model_.skeleton.bones[bone].name;
  }
}

TEST_F(RagdollPose, PutsTheJointsOfBodiesWhereTheirBonesAre) {
  const RagdollState state = fallen(rig_, 5.0);
  const auto origins = bone_origins(model_, rig_, state);
  for (std::size_t b = 0; b < rig_.bodies.size(); ++b) {
    const glm::dvec3 joint(joint_of(rig_, state, static_cast<int>(b)));
    EXPECT_LT(glm::distance(joint, origins[static_cast<std::size_t>(rig_.bodies[b].bone)]), 0.003) << b;
  }
}

TEST_F(RagdollPose, LeavesOtherBonesAsTheyAre) {
  const int finger = 12;
  ASSERT_EQ(std::ranges::count(rig_.bodies, finger, &RagdollBody::bone), 0);
  ASSERT_EQ(std::ranges::count(rig_.links, finger, &RagdollLink::bone), 0);
  Pose pose = bent();
  const glm::quat curled = glm::angleAxis(0.8F, glm::vec3(1.0F, 0.0F, 0.0F));
  pose.view().set_rotation(finger, curled);
  ragdoll_to_pose(rig_, fallen(rig_, 1.0), pose.view());
  EXPECT_EQ(pose.view().rotation(finger), curled);
}

TEST_F(RagdollPose, WritesNothingAboveTheBonesThatAreThere) {
  Pose pose = bent();
  PoseView fewer = pose.view();
  fewer.bone_count = 8;
  const glm::quat before = pose.view().rotation(8);
  ragdoll_to_pose(rig_, fallen(rig_, 1.0), fewer);
  for (int bone = 8; bone < model_.skeleton.bone_count(); ++bone)
    EXPECT_EQ(pose.view().position(bone), glm::vec3(0.0F));
  EXPECT_EQ(pose.view().rotation(8), before);
}

TEST_F(RagdollPose, TakesOverTheMovementBetweenTwoPoses) {
  Pose before(model_.skeleton.bone_count());
  Pose now(model_.skeleton.bone_count());
  const int hips = rig_.bodies[0].bone;
  now.view().set_position(hips, {0.0F, 0.0F, 0.02F});
  now.view().set_rotation(hips, glm::angleAxis(0.01F, glm::vec3(0.0F, 1.0F, 0.0F)));
  RagdollState state;
  ragdoll_from_pose(
      rig_,
      {.before = before.view(), .now = now.view(), .elapsed = ticks_per_second / 50, .velocity = {0.5F, 0.0F, 0.0F}},
      state);
  EXPECT_NEAR(state.bodies[0].velocity.z, 1.0F, 1e-3F);
  EXPECT_NEAR(state.bodies[0].velocity.x, 0.5F, 0.01F);
  for (std::size_t b = 0; b < rig_.bodies.size(); ++b) EXPECT_NEAR(state.bodies[b].angular_velocity.y, 0.5F, 1e-3F);
}

}  // namespace
}  // namespace throng::anim::ragdoll_pose_test
