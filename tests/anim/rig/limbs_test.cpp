#include "engine/anim/rig/limbs.h"

#include <map>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/bone_mask.h"
#include "tests/anim/rig/named_skeleton.h"

namespace throng::anim::limbs_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// The person with other names; what is not in the list keeps its name.
Skeleton renamed(const std::map<std::string, std::string>& names) {
  Skeleton skeleton = named_skeleton(person_joints());
  for (Bone& bone : skeleton.bones) {
    if (const auto found = names.find(bone.name); found != names.end()) bone.name = found->second;
  }
  return skeleton;
}

Skeleton nameless() {
  Skeleton skeleton = named_skeleton(person_joints());
  for (Bone& bone : skeleton.bones) bone.name = "node " + std::to_string(bone.node);
  return skeleton;
}

void expect_limb(const std::optional<LimbBones>& limb, const Skeleton& person, const char* upper, const char* middle,
                 const char* end, int tip = -1) {
  ASSERT_TRUE(limb.has_value());
  EXPECT_EQ(limb->upper, find_bone(person, upper));
  EXPECT_EQ(limb->middle, find_bone(person, middle));
  EXPECT_EQ(limb->end, find_bone(person, end));
  EXPECT_EQ(limb->tip, tip);
}

/// Every skeleton here has the bones of the person, whatever they are called.
void expect_person(const Limbs& limbs) {
  const Skeleton person = named_skeleton(person_joints());
  expect_limb(limbs.left_leg, person, "thigh.L", "shin.L", "foot.L", find_bone(person, "toe.L"));
  expect_limb(limbs.right_leg, person, "thigh.R", "shin.R", "foot.R", find_bone(person, "toe.R"));
  expect_limb(limbs.left_arm, person, "upper_arm.L", "forearm.L", "hand.L");
  expect_limb(limbs.right_arm, person, "upper_arm.R", "forearm.R", "hand.R");
  EXPECT_EQ(limbs.pelvis, find_bone(person, "hips"));
  EXPECT_EQ(limbs.head, find_bone(person, "head"));
  EXPECT_THAT(limbs.spine,
              ElementsAre(find_bone(person, "spine"), find_bone(person, "chest"), find_bone(person, "neck")));
  EXPECT_LT(glm::distance(limbs.forward, {0.0F, 0.0F, 1.0F}), 1e-5F);
  EXPECT_TRUE(limbs.doubts.empty()) << limbs.doubts.front();
}

std::map<std::string, std::string> both_sides(const std::map<std::string, std::string>& names, const char* left,
                                              const char* right) {
  std::map<std::string, std::string> all;
  for (const auto& [person, scheme] : names) {
    const std::size_t side = scheme.find('*');
    all[person + ".L"] = std::string(scheme).replace(side, 1, left);
    all[person + ".R"] = std::string(scheme).replace(side, 1, right);
  }
  return all;
}

TEST(Limbs, AreFoundByOurOwnNames) {
  const Limbs limbs = find_limbs(named_skeleton(person_joints()));
  expect_person(limbs);
  EXPECT_TRUE(limbs.named);
}

TEST(Limbs, AreFoundByNamesOfMixamo) {
  auto names = both_sides({{"thigh", "mixamorig:*UpLeg"},
                           {"shin", "mixamorig:*Leg"},
                           {"foot", "mixamorig:*Foot"},
                           {"toe", "mixamorig:*ToeBase"},
                           {"upper_arm", "mixamorig:*Arm"},
                           {"forearm", "mixamorig:*ForeArm"},
                           {"hand", "mixamorig:*Hand"}},
                          "Left", "Right");
  names.insert({{"hips", "mixamorig:Hips"}, {"head", "mixamorig:Head"}, {"chest", "mixamorig:Spine1"}});
  expect_person(find_limbs(renamed(names)));
}

TEST(Limbs, AreFoundByNamesOfUnreal) {
  expect_person(find_limbs(renamed(both_sides({{"thigh", "thigh_*"},
                                               {"shin", "calf_*"},
                                               {"foot", "foot_*"},
                                               {"toe", "ball_*"},
                                               {"upper_arm", "upperarm_*"},
                                               {"forearm", "lowerarm_*"},
                                               {"hand", "hand_*"}},
                                              "l", "r"))));
}

TEST(Limbs, AreFoundByNamesOfVrm) {
  expect_person(find_limbs(renamed(both_sides({{"thigh", "J_Bip_*_UpperLeg"},
                                               {"shin", "J_Bip_*_LowerLeg"},
                                               {"foot", "J_Bip_*_Foot"},
                                               {"toe", "J_Bip_*_ToeBase"},
                                               {"upper_arm", "J_Bip_*_UpperArm"},
                                               {"forearm", "J_Bip_*_LowerArm"},
                                               {"hand", "J_Bip_*_Hand"}},
                                              "L", "R"))));
}

TEST(Limbs, AreFoundByNamesOfJoints) {
  expect_person(find_limbs(renamed(both_sides({{"thigh", "*Hip"},
                                               {"shin", "*Knee"},
                                               {"foot", "*Ankle"},
                                               {"toe", "*Toe"},
                                               {"upper_arm", "*Shoulder"},
                                               {"forearm", "*Elbow"},
                                               {"hand", "*Wrist"}},
                                              "Left", "Right"))));
}

TEST(Limbs, AreFoundByNamesOfRigifyWhichHasNoHead) {
  auto names = both_sides({{"thigh", "DEF-thigh.*"}, {"shin", "DEF-shin.*"}, {"foot", "DEF-foot.*"}}, "L", "R");
  names.insert({{"spine", "DEF-spine.001"}, {"chest", "DEF-spine.003"}, {"neck", "DEF-spine.004"}});
  names.insert({{"head", "DEF-spine.006"}});
  expect_person(find_limbs(renamed(names)));
}

/// Gives the person's bones names that say nothing, and these roles.
Skeleton with_roles(const std::map<std::string, BodyRole>& roles) {
  Skeleton skeleton = named_skeleton(person_joints());
  for (Bone& bone : skeleton.bones) {
    if (const auto role = roles.find(bone.name); role != roles.end()) bone.role = role->second;
    bone.name = "node " + std::to_string(bone.node);
  }
  return skeleton;
}

const std::map<std::string, BodyRole>& roles_of_the_person() {
  static const std::map<std::string, BodyRole> roles{
      {"hips", BodyRole::hips},
      {"head", BodyRole::head},
      {"thigh.L", BodyRole::left_upper_leg},
      {"shin.L", BodyRole::left_lower_leg},
      {"foot.L", BodyRole::left_foot},
      {"toe.L", BodyRole::left_toes},
      {"upper_arm.L", BodyRole::left_upper_arm},
      {"forearm.L", BodyRole::left_lower_arm},
      {"hand.L", BodyRole::left_hand},
      {"thigh.R", BodyRole::right_upper_leg},
      {"shin.R", BodyRole::right_lower_leg},
      {"foot.R", BodyRole::right_foot},
      {"toe.R", BodyRole::right_toes},
      {"upper_arm.R", BodyRole::right_upper_arm},
      {"forearm.R", BodyRole::right_lower_arm},
      {"hand.R", BodyRole::right_hand},
  };
  return roles;
}

TEST(Limbs, AreThoseThatTheFileOrAPersonSays) {
  const Limbs limbs = find_limbs(with_roles(roles_of_the_person()));
  expect_person(limbs);
  EXPECT_TRUE(limbs.named);
}

TEST(Limbs, BelieveWhatIsSaidBeforeNames) {
  Skeleton skeleton = with_roles(roles_of_the_person());
  skeleton.bones[static_cast<std::size_t>(find_bone(named_skeleton(person_joints()), "toe.L"))].name = "LeftFoot";
  skeleton.bones[0].name = "Head";
  expect_person(find_limbs(skeleton));
}

/// The person with feet that hang on the root, as rigs have them whose IK was baked.
Skeleton with_feet_apart() {
  std::vector<NamedJoint> joints = person_joints();
  for (NamedJoint& joint : joints) {
    if (joint.name.starts_with("foot")) joint.parent = "root";
  }
  return named_skeleton(joints);
}

TEST(Limbs, KnowFeetThatStandApartFromTheirLegs) {
  const Skeleton skeleton = with_feet_apart();
  const Limbs limbs = find_limbs(skeleton);
  expect_limb(limbs.left_leg, skeleton, "thigh.L", "shin.L", "foot.L", find_bone(skeleton, "toe.L"));
  expect_limb(limbs.right_leg, skeleton, "thigh.R", "shin.R", "foot.R", find_bone(skeleton, "toe.R"));
  EXPECT_TRUE(limbs.left_leg->end_stands_apart && limbs.right_leg->end_stands_apart);
  EXPECT_FALSE(limbs.left_arm->end_stands_apart);
  EXPECT_EQ(limbs.pelvis, find_bone(skeleton, "hips"));
}

TEST(Limbs, EndInThePalmThatCarriesMostFingers) {
  std::vector<NamedJoint> joints = person_joints();
  for (NamedJoint& joint : joints) {
    if (joint.name == "hand.L") joint.name = "Palm2.L";
  }
  joints.push_back({"Palm1.L", "forearm.L", {0.2F, 0.86F, 0.02F}});
  joints.push_back({"Palm3.L", "forearm.L", {0.2F, 0.86F, 0.0F}});
  joints.push_back({"Thumb.L", "Palm2.L", {0.2F, 0.8F, 0.03F}});
  const Skeleton skeleton = named_skeleton(joints);
  expect_limb(find_limbs(skeleton).left_arm, skeleton, "upper_arm.L", "forearm.L", "Palm2.L");
}

TEST(Limbs, AreFoundByShapeWhereBonesHaveNoNames) {
  const Limbs limbs = find_limbs(nameless());
  expect_person(limbs);
  EXPECT_FALSE(limbs.named);
}

TEST(Limbs, AreFoundByShapeWhicheverWayTheBodyFaces) {
  Skeleton skeleton = nameless();
  for (ReferenceFrame& frame : skeleton.references) frame.origin = {frame.origin.z, frame.origin.y, -frame.origin.x};
  const Limbs limbs = find_limbs(skeleton);
  EXPECT_LT(glm::distance(limbs.forward, {1.0F, 0.0F, 0.0F}), 1e-5F);
  EXPECT_EQ(limbs.left_leg->upper, find_bone(named_skeleton(person_joints()), "thigh.L"));
}

TEST(Limbs, AreLeftOutWhereLeftAndRightAreSwapped) {
  Skeleton skeleton = named_skeleton(person_joints());
  for (ReferenceFrame& frame : skeleton.references) frame.origin.x = -frame.origin.x;
  const Limbs limbs = find_limbs(skeleton);
  EXPECT_FALSE(limbs.left_leg || limbs.right_leg);
  EXPECT_THAT(limbs.doubts, Contains(HasSubstr("left and right of the legs seem swapped")));
}

TEST(Limbs, AreLeftOutWhereFeetHangOnControlsAndLegsHaveNoHalves) {
  std::vector<NamedJoint> joints = person_joints();
  for (NamedJoint& joint : joints) {
    if (joint.name.starts_with("foot")) joint.parent = "root";
  }
  Skeleton skeleton = named_skeleton(joints);
  for (const char* shin : {"shin.L", "shin.R"}) {
    skeleton.bones[static_cast<std::size_t>(find_bone(skeleton, shin))].name = "unknown";
  }
  const Limbs limbs = find_limbs(skeleton);
  EXPECT_FALSE(limbs.left_leg || limbs.right_leg);
  EXPECT_THAT(limbs.doubts,
              Contains(HasSubstr("'person': the bone that is called the end of the left leg is not below")));
  EXPECT_TRUE(limbs.head) << "the rest of the body is still there";
  EXPECT_TRUE(limbs.left_arm);
}

TEST(Limbs, AreLeftOutWhereTwoBonesCouldBeTheHand) {
  std::vector<NamedJoint> joints = person_joints();
  joints.push_back({"palm.L", "forearm.L", {0.22F, 0.86F, 0.0F}});
  const Limbs limbs = find_limbs(named_skeleton(joints));
  EXPECT_FALSE(limbs.left_arm);
  EXPECT_TRUE(limbs.right_arm);
  EXPECT_THAT(limbs.doubts, ElementsAre(HasSubstr("two bones could end the left arm")));
}

TEST(Limbs, AreNotImaginedInASnake) {
  const Limbs limbs = find_limbs(named_skeleton({{"a", "", {0, 0, 0}}, {"b", "a", {0, 0, 1}}, {"c", "b", {0, 0, 2}}}));
  EXPECT_FALSE(limbs.left_leg || limbs.right_leg || limbs.left_arm || limbs.right_arm || limbs.pelvis || limbs.head);
  EXPECT_FALSE(limbs.doubts.empty());
}

}  // namespace
}  // namespace throng::anim::limbs_test
