#include "engine/anim/kernel/joint_chain.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/bone_mask.h"
#include "tests/anim/asset/named_skeleton.h"
#include "tests/anim/kernel/held_pose.h"
#include "tests/anim/kernel/kernel_rig.h"

namespace throng::anim {
namespace {

using testing::HasSubstr;

TEST(JointChain, PosesItsJointsAsTheWholeSkeletonWould) {
  const Skeleton skeleton = kernel_rig::rigid_skeleton(kernel_rig::branching_parents(60));
  HeldPose pose(skeleton);
  std::mt19937 random(3);
  pose.shake(random, 1.0F);
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const Result<JointChain> chain = make_joint_chain(skeleton, bone);
    if (!chain) continue;
    ChainMotion motions;
    pose_chain(*chain, pose.view(), motions);
    const JointMotion tip = motions[static_cast<std::size_t>(chain->tip())];
    const JointMotion expected = joint_by_definition(skeleton, pose.view(), bone);
    EXPECT_LT(glm::distance(tip.position, expected.position), 1e-5F) << bone;
    EXPECT_LT(angle_between(tip.rotation, expected.rotation), 2e-6F) << bone;
  }
}

class ChainOfAnArm : public testing::Test {
 protected:
  int bone(const char* name) const { return find_bone(skeleton_, name); }
  Skeleton skeleton_ = named_skeleton(person_joints());
  HeldPose pose_{skeleton_};
  JointChain chain_ = make_joint_chain(skeleton_, find_bone(skeleton_, "hand.L")).value();
};

TEST_F(ChainOfAnArm, GoesFromTheRootToTheTip) {
  EXPECT_EQ(chain_.count, 7);
  EXPECT_EQ(chain_.bones[0], bone("root"));
  EXPECT_EQ(chain_.find(bone("chest")), 3);
  EXPECT_EQ(chain_.bones[static_cast<std::size_t>(chain_.tip())], bone("hand.L"));
  EXPECT_EQ(chain_.find(bone("head")), -1);
}

TEST_F(ChainOfAnArm, TurnsAJointInModelSpaceAndWhatIsBelowFollows) {
  std::mt19937 random(5);
  pose_.shake(random, 0.5F);
  ChainMotion motions;
  pose_chain(chain_, pose_.view(), motions);
  const JointMotion elbow = joint_by_definition(skeleton_, pose_.view(), "forearm.L");
  const JointMotion hand = joint_by_definition(skeleton_, pose_.view(), "hand.L");
  const glm::quat turn = glm::angleAxis(0.8F, glm::vec3(0.0F, 0.0F, 1.0F));

  const JointTurn turned_elbow{chain_.find(bone("forearm.L")), turn * elbow.rotation};
  turn_joints(chain_, {&turned_elbow, 1}, pose_.view(), motions);

  const JointMotion turned = joint_by_definition(skeleton_, pose_.view(), "hand.L");
  EXPECT_LT(angle_between(turned.rotation, turn * hand.rotation), 2e-6F);
  EXPECT_LT(glm::distance(turned.position, elbow.position + turn * (hand.position - elbow.position)), 1e-6F);
  EXPECT_LT(glm::distance(motions[6].position, turned.position), 1e-6F) << "the motions at hand are kept up to date";
}

TEST_F(ChainOfAnArm, ShiftsAJointInModelSpaceAndWhatIsBelowFollows) {
  std::mt19937 random(6);
  pose_.shake(random, 0.5F);
  ChainMotion motions;
  pose_chain(chain_, pose_.view(), motions);
  const glm::vec3 hand = motions[6].position;
  const glm::vec3 shift(0.1F, -0.2F, 0.3F);
  shift_joint(chain_, chain_.find(bone("hips")), shift, pose_.view(), motions);
  EXPECT_LT(glm::distance(joint_by_definition(skeleton_, pose_.view(), "hand.L").position, hand + shift), 1e-6F);
  EXPECT_LT(glm::distance(motions[6].position, hand + shift), 1e-6F);
}

TEST_F(ChainOfAnArm, IsNotWithinALevelOfDetailThatLacksItsTip) {
  PoseView view = pose_.view();
  EXPECT_TRUE(is_within(chain_, view));
  view.bone_count = bone("hand.L");
  EXPECT_FALSE(is_within(chain_, view));
}

TEST_F(ChainOfAnArm, IsRefusedForABoneThatIsNotThere) {
  EXPECT_THAT(make_joint_chain(skeleton_, -1).error().message, HasSubstr("'person' has no bone -1"));
  EXPECT_THAT(make_joint_chain(skeleton_, 99).error().message, HasSubstr("has no bone 99"));
}

TEST_F(ChainOfAnArm, IsRefusedForASkeletonThatScalesItsBones) {
  skeleton_.rigid = false;
  EXPECT_THAT(make_joint_chain(skeleton_, bone("hand.L")).error().message, HasSubstr("scales or shears its bones"));
}

TEST(JointChain, IsRefusedBeyond24Joints) {
  const Skeleton skeleton = kernel_rig::rigid_skeleton(kernel_rig::chain_parents(30));
  EXPECT_EQ(make_joint_chain(skeleton, 23)->count, 24);
  EXPECT_THAT(make_joint_chain(skeleton, 24).error().message, HasSubstr("more than 24 joints below its root"));
}

}  // namespace
}  // namespace throng::anim
