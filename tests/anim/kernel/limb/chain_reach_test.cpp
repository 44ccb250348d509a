// A tail that reaches for things: what reach_with_chain promises.

#include "engine/anim/kernel/limb/chain_reach.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/anim/kernel/pose/held_pose.h"
#include "tests/anim/kernel/validity.h"
#include "tests/anim/rig/named_skeleton.h"

namespace throng::anim::chain_reach_test {
namespace {

using testing::HasSubstr;

constexpr float segment = 0.2F;
constexpr int joints = 7;  // of the tail, its end included
constexpr float length = segment * (joints - 1);

std::vector<NamedJoint> body_with_tail() {
  std::vector<NamedJoint> all{{"body", "", {0.0F, 1.0F, 0.0F}}, {"rump", "body", {0.0F, 1.0F, -0.2F}}};
  for (int i = 0; i < joints; ++i) {
    all.push_back(
        {"tail." + std::to_string(i), all.back().name, {0.0F, 1.0F, -0.3F - segment * static_cast<float>(i)}});
  }
  return all;
}

class Tail : public testing::Test {
 protected:
  ChainReachJob job(const glm::vec3& target) { return {.reach = &reach_, .pose = pose_.view(), .target = target}; }
  glm::vec3 place(int joint) {
    return joint_by_definition(skeleton_, pose_.view(), "tail." + std::to_string(joint)).position;
  }
  /// A pose that is anything, but keeps the lengths of bones.
  void curl(std::mt19937& random, float radians) {
    pose_ = HeldPose(skeleton_);
    for (int bone = 0; bone < skeleton_.bone_count(); ++bone) {
      pose_.view().set_rotation(bone,
                                glm::angleAxis(random_between(random, -radians, radians), random_direction(random)));
    }
  }

  Skeleton skeleton_ = named_skeleton(body_with_tail());
  HeldPose pose_{skeleton_};
  ReachChain reach_ = make_reach_chain(skeleton_, 2, 2 + joints - 1).value();
};

TEST_F(Tail, IsValidAsItsCommentsSay) {
  expect_validity<ChainReachJob>(
      job({0.5F, 1.0F, -1.0F}),
      {{false, "no chain", [](ChainReachJob& job) { job.reach = nullptr; }},
       {false, "no pose", [](ChainReachJob& job) { job.pose.first = nullptr; }},
       {false, "no iterations", [](ChainReachJob& job) { job.iterations = 0; }},
       {false, "too many iterations", [](ChainReachJob& job) { job.iterations = most_reach_iterations + 1; }},
       {false, "a tolerance below 0", [](ChainReachJob& job) { job.tolerance = -1.0F; }},
       {true, "weight 0", [](ChainReachJob& job) { job.weight = 0.0F; }},
       {false, "weight not a number", [](ChainReachJob& job) { job.weight = std::nanf(""); }}});
}

TEST_F(Tail, ReachesAThousandTargetsAndKeepsTheLengthsOfBones) {
  std::mt19937 random(3);
  for (int i = 0; i < 1000; ++i) {
    curl(random, 0.5F);
    const glm::vec3 root = place(0);
    const glm::vec3 target = root + random_between(random, 0.1F, 0.95F) * length * random_direction(random);
    ChainReachJob reaching = job(target);
    reaching.iterations = most_reach_iterations;
    EXPECT_LT(reach_with_chain(reaching), 2e-3F) << i;
    EXPECT_LT(glm::distance(place(joints - 1), target), 2e-3F) << i;
    EXPECT_LT(glm::distance(place(0), root), 1e-5F) << "its root stays";
    for (int joint = 1; joint < joints; ++joint) {
      EXPECT_NEAR(glm::distance(place(joint), place(joint - 1)), segment, 1e-5F);
    }
  }
}

TEST_F(Tail, NearlyReachesWithTheUsualIterations) {
  std::mt19937 random(4);
  for (int i = 0; i < 300; ++i) {
    curl(random, 0.5F);
    const glm::vec3 target = place(0) + random_between(random, 0.2F, 0.9F) * length * random_direction(random);
    EXPECT_LT(reach_with_chain(job(target)), 0.02F) << i;
  }
}

TEST_F(Tail, StretchesOutStraightTowardsATargetOutOfReach) {
  std::mt19937 random(5);
  for (int i = 0; i < 50; ++i) {
    curl(random, 0.5F);
    const glm::vec3 way = random_direction(random);
    const glm::vec3 root = place(0);
    EXPECT_NEAR(reach_with_chain(job(root + 2.0F * length * way)), length, 1e-3F);
    for (int joint = 1; joint < joints; ++joint) {
      EXPECT_LT(glm::distance(place(joint), root + segment * static_cast<float>(joint) * way), 1e-3F);
    }
  }
}

TEST_F(Tail, MovesSmoothlyWithATargetThatLeavesItsReach) {
  glm::vec3 last(0.0F);
  for (int i = 0; i <= 200; ++i) {
    pose_ = HeldPose(skeleton_);
    const float away = length * (0.9F + 0.001F * static_cast<float>(i));
    reach_with_chain(job(place(0) + away * glm::normalize(glm::vec3(1.0F, 0.5F, -1.0F))));
    EXPECT_LT(i == 0 ? 0.0F : glm::distance(place(joints - 1), last), 0.02F) << i;
    last = place(joints - 1);
  }
}

TEST_F(Tail, BendsWhenItIsStraightAndItsTargetIsOnItsLine) {
  const glm::vec3 target = place(0) + glm::vec3(0.0F, 0.0F, -0.7F * length);
  ChainReachJob reaching = job(target);
  reaching.iterations = most_reach_iterations;
  EXPECT_LT(reach_with_chain(reaching), 2e-3F);
}

TEST_F(Tail, TurnsNoJointAboutItsOwnBone) {
  std::mt19937 random(6);
  for (int i = 0; i < 100; ++i) {
    pose_ = HeldPose(skeleton_);
    reach_with_chain(job(place(0) + random_between(random, 0.3F, 0.9F) * length * random_direction(random)));
    for (int bone = reach_.first; bone < reach_.chain.tip(); ++bone) {
      const glm::quat turn = pose_.view().rotation(reach_.chain.bones[static_cast<std::size_t>(bone)]);
      EXPECT_NEAR(turn.z, 0.0F, 1e-4F) << "the bones lie along z, and the bind pose has no turns";
    }
  }
}

TEST_F(Tail, StaysToTheBitWithoutWeightBonesOrATargetThatIsAPlace) {
  const std::vector<float> before = pose_.floats();
  ChainReachJob weightless = job({0.5F, 1.0F, -0.5F});
  weightless.weight = 0.0F;
  EXPECT_GT(reach_with_chain(weightless), 0.1F) << "and it says how far it is";
  EXPECT_EQ(pose_.floats(), before);
  ChainReachJob coarse = job({0.5F, 1.0F, -0.5F});
  coarse.pose.bone_count = 4;
  EXPECT_EQ(reach_with_chain(coarse), 0.0F);
  EXPECT_EQ(pose_.floats(), before);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const glm::vec3& nowhere : {glm::vec3(nan), glm::vec3(0.0F, std::numeric_limits<float>::infinity(), 0.0F)}) {
    EXPECT_EQ(reach_with_chain(job(nowhere)), 0.0F);
    EXPECT_EQ(pose_.floats(), before);
  }
}

TEST_F(Tail, GoesPartOfTheWayWithPartOfTheWeight) {
  const glm::vec3 target = place(0) + glm::vec3(0.4F * length, 0.0F, -0.4F * length);
  const float whole_way = glm::distance(place(joints - 1), target);
  ChainReachJob half = job(target);
  half.weight = 0.5F;
  const float left = reach_with_chain(half);
  EXPECT_GT(left, 0.05F * whole_way);
  EXPECT_LT(left, 0.95F * whole_way);
}

TEST_F(Tail, StaysFiniteWithTheTargetAtItsRoot) {
  reach_with_chain(job(place(0)));
  EXPECT_TRUE(pose_.is_finite());
}

TEST(ReachChain, IsRefusedWhereNoChainLeadsDown) {
  const Skeleton skeleton = named_skeleton(body_with_tail());
  EXPECT_THAT(make_reach_chain(skeleton, 4, 3).error().message, HasSubstr("is not below bone 'tail.2'"));
  EXPECT_THAT(make_reach_chain(skeleton, 3, 3).error().message, HasSubstr("is not below"));
  EXPECT_THAT(make_reach_chain(skeleton, 2, 99).error().message, HasSubstr("has no bone 99"));
}

}  // namespace
}  // namespace throng::anim::chain_reach_test
