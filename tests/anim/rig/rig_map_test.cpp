#include "engine/anim/rig/rig_map.h"

#include <gtest/gtest.h>

#include "engine/anim/asset/bone_mask.h"
#include "tests/anim/rig/named_skeleton.h"

namespace throng::anim::rig_map_test {
namespace {

TEST(RigMap, KnowsEveryPartOfAPerson) {
  const Skeleton person = named_skeleton(person_joints());
  const RigMap rig = find_rig(person);
  const auto expect = [&](BodyRole role, const char* bone) {
    EXPECT_EQ(rig.at(role), find_bone(person, bone)) << name_of(role);
  };
  expect(BodyRole::hips, "hips");
  expect(BodyRole::spine, "spine");
  expect(BodyRole::chest, "chest");
  expect(BodyRole::neck, "neck");
  expect(BodyRole::head, "head");
  expect(BodyRole::left_upper_arm, "upper_arm.L");
  expect(BodyRole::left_lower_arm, "forearm.L");
  expect(BodyRole::left_hand, "hand.L");
  expect(BodyRole::right_upper_leg, "thigh.R");
  expect(BodyRole::right_lower_leg, "shin.R");
  expect(BodyRole::right_foot, "foot.R");
  expect(BodyRole::right_toes, "toe.R");
  EXPECT_EQ(rig.at(BodyRole::left_shoulder), -1) << "the person has no collar bones";
}

TEST(RigMap, PutsWhatIsSaidFirst) {
  Skeleton person = named_skeleton(person_joints());
  const int root = find_bone(person, "root");
  person.bones[static_cast<std::size_t>(root)].role = BodyRole::hips;
  EXPECT_EQ(find_rig(person).at(BodyRole::hips), root);
}

TEST(RigMap, HasNoPartsInAChain) {
  const RigMap rig = find_rig(named_skeleton({{"a", "", {0, 0, 0}}, {"b", "a", {0, 0, 1}}, {"c", "b", {0, 0, 2}}}));
  for (const int bone : rig.bones) EXPECT_EQ(bone, -1);
}

TEST(BodyRoles, HaveTheNamesOfVrm) {
  EXPECT_EQ(body_role_named("leftUpperLeg"), BodyRole::left_upper_leg);
  EXPECT_EQ(body_role_named("rightToes"), BodyRole::right_toes);
  EXPECT_EQ(body_role_named("leftEye"), std::nullopt);
}

}  // namespace
}  // namespace throng::anim::rig_map_test
