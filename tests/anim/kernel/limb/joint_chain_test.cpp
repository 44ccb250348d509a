#include "engine/anim/kernel/limb/joint_chain.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/bone_mask.h"
#include "tests/anim/kernel/kernel_rig.h"
#include "tests/anim/kernel/pose/held_pose.h"
#include "tests/anim/rig/named_skeleton.h"

namespace throng::anim::joint_chain_test {
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
}  // namespace throng::anim::joint_chain_test
