#include "engine/anim/rig/spring_rig.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/anim/rig/named_skeleton.h"

namespace throng::anim::spring_rig_test {
namespace {

using testing::HasSubstr;

std::string error_of(const std::vector<SpringChain>& chains, const std::vector<SpringCollider>& colliders = {}) {
  const Result<SpringRig> rig = make_spring_rig(named_skeleton(person_joints()), chains, colliders);
  return rig ? "" : rig.error().message;
}

TEST(SpringRig, HasTheJointsOfEachChainFromItsRootDown) {
  const Skeleton person = named_skeleton(person_joints());
  const SpringRig rig = make_spring_rig(person,
                                        std::vector<SpringChain>{{.first = "upper_arm.L", .last = "hand.L"},
                                                                 {.first = "head", .last = "head", .tip = 0.2F}},
                                        std::vector<SpringCollider>{{.bone = "hips"}})
                            .value();
  ASSERT_EQ(rig.chains.size(), 2U);
  EXPECT_EQ(rig.chains[0].count, 2) << "the hand only ends the chain";
  EXPECT_EQ(rig.chains[1].count, 1);
  ASSERT_EQ(rig.joints.size(), 3U);
  EXPECT_NEAR(rig.joints[2].length, 0.2F, 1e-6F);
  for (const SpringJoint& joint : rig.joints) EXPECT_NEAR(joint.length, glm::length(joint.tail), 1e-6F);
  for (std::size_t node = 0; node < rig.nodes.size(); ++node) {
    EXPECT_LT(rig.nodes[node].parent, static_cast<int>(node));
    EXPECT_LT(rig.nodes[node].bone, rig.bone_end);
  }
}

TEST(SpringRig, IsRefusedWithASentenceThatSaysWhatToMend) {
  EXPECT_THAT(error_of({}), HasSubstr("no chain was named"));
  EXPECT_THAT(error_of({{.first = "plait", .last = "head"}}), HasSubstr("no bone is called 'plait'"));
  EXPECT_THAT(error_of({{.first = "head", .last = "hips"}}), HasSubstr("does not lead down"));
  EXPECT_THAT(error_of({{.first = "head", .last = "head"}}), HasSubstr("has no length"));
  EXPECT_THAT(error_of({{.first = "thigh.L", .last = "foot.L"}, {.first = "shin.L", .last = "toe.L"}}),
              HasSubstr("shares a bone with another chain"));
  EXPECT_THAT(error_of({{.first = "head", .last = "head", .options = {.stiffness = -1.0F}, .tip = 0.1F}}),
              HasSubstr("negative or not finite"));
  EXPECT_THAT(error_of({{.first = "head", .last = "head", .tip = 0.1F}}, {{.bone = "hips", .radius = std::nanf("")}}),
              HasSubstr("the collider at 'hips' is negative or not finite"));
  EXPECT_THAT(error_of({{.first = "head", .last = "head", .tip = 0.1F}}, std::vector<SpringCollider>(17, {"hips"})),
              HasSubstr("17 colliders of at most 16"));
}

}  // namespace
}  // namespace throng::anim::spring_rig_test
