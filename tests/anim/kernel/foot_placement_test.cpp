#include "engine/anim/kernel/foot_placement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/bone_mask.h"
#include "tests/anim/asset/named_skeleton.h"
#include "tests/anim/kernel/held_pose.h"

namespace throng::anim {
namespace {

using testing::HasSubstr;

constexpr float frame = 1.0F / 60.0F;
constexpr float planted[] = {1.0F, 1.0F};
constexpr float lifted[] = {0.0F, 0.0F};

LegBones leg_bones(const Skeleton& skeleton, const std::string& side) {
  return {find_bone(skeleton, "thigh" + side), find_bone(skeleton, "shin" + side), find_bone(skeleton, "foot" + side),
          find_bone(skeleton, "toe" + side)};
}

/// A plane through the model's origin that rises `degrees` towards `uphill`.
struct Slope {
  Slope(float degrees, const glm::vec3& uphill)
      : normal(glm::normalize(glm::vec3(0.0F, 1.0F, 0.0F) -
                              std::tan(degrees * std::numbers::pi_v<float> / 180.0F) * uphill)) {}
  GroundContact under(const glm::vec3& point) const {
    return {-(point.x * normal.x + point.z * normal.z) / normal.y, normal};
  }
  float above(const glm::vec3& point) const { return glm::dot(point, normal); }
  glm::vec3 normal;
};

class PersonOnGround : public testing::Test {
 protected:
  glm::vec3 place(const char* bone) { return joint_by_definition(skeleton_, pose_.view(), bone).position; }

  FootPlacementJob job(std::span<const float> are_planted) {
    return {.rig = &rig_,
            .state = &state_,
            .pose = pose_.view(),
            .contacts = contacts_,
            .planted = are_planted,
            .seconds = frame};
  }
  FootPlacementResult stand_on(const Slope& slope, std::span<const float> are_planted) {
    PosedLegs legs;
    EXPECT_TRUE(pose_legs(rig_, pose_.view(), legs));
    for (std::size_t i = 0; i < 2; ++i) contacts_[i] = slope.under(ankle_of(rig_, legs, i));
    return place_feet(job(are_planted));
  }
  /// Height of heel and ball of a foot above the ground, by the definition of the pose.
  std::pair<float, float> sole_above(const Slope& slope, std::size_t leg) {
    const JointMotion ankle = joint_by_definition(
        skeleton_, pose_.view(), rig_.legs[leg].limb.chain.bones[static_cast<std::size_t>(rig_.legs[leg].limb.end())]);
    return {slope.above(ankle.position + ankle.rotation * rig_.legs[leg].sole[0]),
            slope.above(ankle.position + ankle.rotation * rig_.legs[leg].sole[1])};
  }

  Skeleton skeleton_ = named_skeleton(person_joints());
  HeldPose pose_{skeleton_};
  FootPlacementRig rig_ =
      make_foot_placement_rig(skeleton_, std::vector{leg_bones(skeleton_, ".L"), leg_bones(skeleton_, ".R")}).value();
  FootPlacementState state_;
  GroundContact contacts_[2];
};

TEST_F(PersonOnGround, StandsWithBothSolesOnASlopeOf20DegreesWhicheverWayItRises) {
  for (int direction = 0; direction < 8; ++direction) {
    const float angle = static_cast<float>(direction) * std::numbers::pi_v<float> / 4.0F;
    const Slope slope(20.0F, {std::sin(angle), 0.0F, std::cos(angle)});
    pose_ = HeldPose(skeleton_);
    state_ = {};
    stand_on(slope, planted);
    for (std::size_t leg = 0; leg < 2; ++leg) {
      const auto [heel, ball] = sole_above(slope, leg);
      EXPECT_NEAR(heel, 0.0F, 1e-3F);
      EXPECT_NEAR(ball, 0.0F, 1e-3F);
    }
  }
}

TEST_F(PersonOnGround, TouchesTheSlopeInAnyPoseItsLegsReachFrom) {
  std::mt19937 random(21);
  const Slope slope(20.0F, {0.6F, 0.0F, 0.8F});
  int reached = 0;
  for (int i = 0; i < 200; ++i) {
    pose_ = HeldPose(skeleton_);
    pose_.shake(random, 0.15F);
    state_ = {};
    const FootPlacementResult result = stand_on(slope, planted);
    for (std::size_t leg = 0; leg < 2; ++leg) {
      if (result.missed_by[leg] > 1e-3F) continue;
      ++reached;
      const auto [heel, ball] = sole_above(slope, leg);
      EXPECT_NEAR(std::min(heel, ball), 0.0F, 0.01F);
    }
  }
  EXPECT_GT(reached, 390);
}

TEST_F(PersonOnGround, LeavesFeetOnFlatGroundWhereTheyAre) {
  const glm::vec3 ankle = place("foot.L");
  const glm::vec3 knee = place("shin.L");
  const FootPlacementResult result = stand_on(Slope(0.0F, {1.0F, 0.0F, 0.0F}), planted);
  EXPECT_LT(result.drop, 1e-6F);
  EXPECT_LT(glm::distance(place("foot.L"), ankle), 1e-5F);
  EXPECT_LT(glm::distance(place("shin.L"), knee), 1e-4F);
}

TEST_F(PersonOnGround, LeavesThePoseToTheBitWithoutWeight) {
  const std::vector<float> before = pose_.floats();
  contacts_[0].height = -0.2F;
  FootPlacementJob none = job(planted);
  none.weight = 0.0F;
  place_feet(none);
  EXPECT_EQ(pose_.floats(), before);
}

TEST_F(PersonOnGround, LowersThePelvisForTheFootInAHoleAndNoFurtherThanAllowed) {
  contacts_[0].height = -0.15F;
  EXPECT_NEAR(place_feet(job(planted)).drop, 0.15F, 0.02F);
  EXPECT_NEAR(place("foot.L").y, 0.08F - 0.15F, 1e-3F);
  EXPECT_NEAR(place("foot.R").y, 0.08F, 1e-3F) << "the other stays up";

  pose_ = HeldPose(skeleton_);
  state_ = {};
  contacts_[0].height = -5.0F;
  const FootPlacementResult abyss = place_feet(job(planted));
  EXPECT_FLOAT_EQ(abyss.drop, 0.4F);
  EXPECT_GT(abyss.missed_by[0], 4.0F) << "and it says what it could not reach";
  EXPECT_LT(abyss.missed_by[1], 1e-3F);
}

TEST_F(PersonOnGround, LowersThePelvisSmoothly) {
  place_feet(job(planted));
  contacts_[0].height = -0.2F;
  state_.feet = {};
  float last = 0.0F;
  for (int i = 0; i < 60; ++i) {
    pose_ = HeldPose(skeleton_);
    const float drop = place_feet(job(planted)).drop;
    EXPECT_GE(drop, last);
    EXPECT_LT(drop - last, 0.05F);
    last = drop;
  }
  EXPECT_NEAR(last, 0.2F, 0.02F);
}

TEST_F(PersonOnGround, CarriesLiftedFeetOverTheGroundAsHighAsThePoseDoes) {
  pose_.view().set_position(find_bone(skeleton_, "hips"), {0.0F, 0.1F, 0.0F});
  contacts_[0].height = contacts_[1].height = 0.2F;
  place_feet(job(lifted));
  EXPECT_NEAR(place("foot.L").y, 0.08F + 0.1F + 0.2F, 1e-4F);
}

TEST_F(PersonOnGround, KeepsPlantedFeetInTheWorldWhileTheBodyMovesOn) {
  const auto world_ankle = [&](const JointMotion& model) {
    return model.position + model.rotation * joint_by_definition(skeleton_, pose_.view(), "foot.L").position;
  };
  glm::vec3 first(0.0F);
  for (int i = 0; i < 12; ++i) {
    pose_ = HeldPose(skeleton_);
    pose_.view().set_position(find_bone(skeleton_, "hips"), {0.0F, -0.06F, 0.0F});  // knees bent, as one walks
    FootPlacementJob walk = job(planted);
    const float t = static_cast<float>(i) * frame;
    walk.model_in_world = {.rotation = glm::angleAxis(0.5F, glm::vec3(0.0F, 1.0F, 0.0F)),
                           .position = {40.0F + t, 0.0F, -30.0F - 0.5F * t}};
    place_feet(walk);
    if (i == 0) first = world_ankle(walk.model_in_world);
    EXPECT_LT(glm::distance(world_ankle(walk.model_in_world), first), 1e-4F) << i;
  }
  EXPECT_LT(state_.feet[0].slid, 5e-4F);
  EXPECT_NEAR(state_.feet[0].standing_seconds, 11.0F * frame, 1e-5F);
}

TEST_F(PersonOnGround, TellsHowFarFeetSlideThatAreNotLocked) {
  for (int i = 0; i < 12; ++i) {
    pose_ = HeldPose(skeleton_);
    FootPlacementJob walk = job(planted);
    walk.options.lock.enabled = false;
    walk.model_in_world.position.z = static_cast<float>(i) * frame;
    place_feet(walk);
  }
  EXPECT_NEAR(state_.feet[0].slid, 11.0F * frame, 1e-4F);
}

TEST_F(PersonOnGround, StaysFiniteOnBrokenGround) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const GroundContact& contact :
       {GroundContact{nan, {0, 1, 0}}, GroundContact{0.0F, glm::vec3(nan)}, GroundContact{0.0F, glm::vec3(0.0F)},
        GroundContact{0.0F, {0, -1, 0}}, GroundContact{1e8F, {1, 0, 0}}}) {
    pose_ = HeldPose(skeleton_);
    state_ = {};
    contacts_[0] = contact;
    EXPECT_TRUE(std::isfinite(place_feet(job(planted)).missed_by[0]));
    EXPECT_TRUE(pose_.is_finite());
  }
}

TEST_F(PersonOnGround, IsLeftAloneInALevelOfDetailWithoutAllLegs) {
  const std::vector<float> before = pose_.floats();
  FootPlacementJob coarse = job(planted);
  coarse.pose.bone_count = find_bone(skeleton_, "foot.R");
  contacts_[0].height = -0.2F;
  EXPECT_EQ(place_feet(coarse).drop, 0.0F);
  EXPECT_EQ(pose_.floats(), before);
}

TEST(FootPlacementRig, IsRefusedWithoutLegsAndForLegsThatNothingCarries) {
  const Skeleton person = named_skeleton(person_joints());
  EXPECT_THAT(make_foot_placement_rig(person, {}).error().message, HasSubstr("cannot be placed on 0 legs"));
  const Skeleton stilts = named_skeleton({{"thigh.L", "", {0.1F, 1.0F, 0}},
                                          {"shin.L", "thigh.L", {0.1F, 0.5F, 0.02F}},
                                          {"foot.L", "shin.L", {0.1F, 0.1F, 0}}});
  EXPECT_THAT(make_foot_placement_rig(stilts, std::vector{LegBones{0, 1, 2}}).error().message,
              HasSubstr("no bone of skeleton 'person' carries all its legs"));
}

}  // namespace
}  // namespace throng::anim
