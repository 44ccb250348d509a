#include "engine/anim/rig/limb_names.h"

#include <gtest/gtest.h>

namespace throng::anim::limb_names_test {
namespace {

void expect_name(const char* bone, BodyPart part, BodySide side) {
  const LimbName name = read_limb_name(bone);
  EXPECT_EQ(static_cast<int>(name.part), static_cast<int>(part)) << bone;
  EXPECT_EQ(static_cast<int>(name.side), static_cast<int>(side)) << bone;
}

TEST(LimbNames, AreReadInTheCommonSchemes) {
  expect_name("mixamorig:LeftUpLeg", BodyPart::upper_leg, BodySide::left);
  expect_name("mixamorig1:RightLeg", BodyPart::leg, BodySide::right);
  expect_name("mixamorig:LeftToeBase", BodyPart::toe, BodySide::left);
  expect_name("DEF-thigh.L.001", BodyPart::upper_leg, BodySide::left);
  expect_name("DEF-upper_arm.R", BodyPart::upper_arm, BodySide::right);
  expect_name("calf_l", BodyPart::lower_leg, BodySide::left);
  expect_name("ball_r", BodyPart::toe, BodySide::right);
  expect_name("spine_03", BodyPart::spine, BodySide::none);
  expect_name("J_Bip_R_LowerArm", BodyPart::lower_arm, BodySide::right);
  expect_name("J_Bip_C_UpperChest", BodyPart::spine, BodySide::none);
  expect_name("Bip01 L Foot", BodyPart::foot, BodySide::left);
  expect_name("lShin", BodyPart::lower_leg, BodySide::left);
  expect_name("RThighBend", BodyPart::upper_leg, BodySide::right);
  expect_name("b_LeftForeArm_010", BodyPart::lower_arm, BodySide::left);
  expect_name("leftupleg", BodyPart::upper_leg, BodySide::left);
  expect_name("Skeleton_neck_joint_1", BodyPart::neck, BodySide::none);
}

TEST(LimbNames, AreReadInTheSchemesOfGameCharacters) {
  expect_name("UpperLeg.L", BodyPart::upper_leg, BodySide::left);  // Quaternius
  expect_name("Abdomen", BodyPart::spine, BodySide::none);
  expect_name("Fist.R", BodyPart::hand, BodySide::right);
  expect_name("upperleg.r", BodyPart::upper_leg, BodySide::right);  // KayKit
  expect_name("wrist.l", BodyPart::hand, BodySide::left);
  expect_name("toes.l", BodyPart::toe, BodySide::left);
  expect_name("LeftUpLeg", BodyPart::upper_leg, BodySide::left);  // Ready Player Me
  expect_name("RightToeBase", BodyPart::toe, BodySide::right);
  expect_name("CC_Base_L_Thigh", BodyPart::upper_leg, BodySide::left);
  expect_name("ValveBiped.Bip01_R_Calf", BodyPart::lower_leg, BodySide::right);
  expect_name("lForearmBend", BodyPart::lower_arm, BodySide::left);
  expect_name("Left knee", BodyPart::lower_leg, BodySide::left);
  expect_name("upperarm01.L", BodyPart::upper_arm, BodySide::left);
}

TEST(LimbNames, TellAHipFromTheHips) {
  expect_name("Hips", BodyPart::pelvis, BodySide::none);
  expect_name("LeftHip", BodyPart::upper_leg, BodySide::left);
}

TEST(LimbNames, OfHelpersAreNoJoints) {
  for (const char* helper : {"thigh_twist.L", "ik_foot_l", "kneeIK.l", "HeadTop_End", "PoleTarget.R", "handslot.l"}) {
    EXPECT_EQ(read_limb_name(helper).part, BodyPart::helper) << helper;
  }
}

TEST(LimbNames, OfOtherThingsAreNoParts) {
  for (const char* other : {"", "42", "Ear1.L", "index_01_l", "Armature", "Footstool", "handle"}) {
    EXPECT_EQ(read_limb_name(other).part, BodyPart::other) << other;
  }
}

}  // namespace
}  // namespace throng::anim::limb_names_test
