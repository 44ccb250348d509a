#include "engine/anim/kernel/limb/foot_placement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/bone_mask.h"
#include "tests/anim/kernel/limb/foot_placement_reference.h"
#include "tests/anim/kernel/limb/one_character.h"
#include "tests/anim/kernel/pose/held_pose.h"
#include "tests/anim/kernel/validity.h"
#include "tests/anim/rig/named_skeleton.h"

namespace throng::anim::foot_placement_test {
namespace {

using testing::HasSubstr;

constexpr float frame = 1.0F / 60.0F;
constexpr float planted = 1.0F;
constexpr float lifted = 0.0F;

LegBones leg_bones(const Skeleton& skeleton, const std::string& side) {
  return {find_bone(skeleton, "thigh" + side), find_bone(skeleton, "shin" + side), find_bone(skeleton, "foot" + side),
          find_bone(skeleton, "toe" + side)};
}

/// A plane through the model's origin that rises `degrees` towards `uphill`.
struct Slope {
  Slope(float degrees, const glm::vec3& uphill)
      : normal(glm::normalize(glm::vec3(0.0F, 1.0F, 0.0F) -
                              std::tan(degrees * std::numbers::pi_v<float> / 180.0F) * uphill)) {}
  float above(const glm::vec3& point) const { return glm::dot(point, normal); }
  glm::vec3 normal;
};

class PersonOnGround : public testing::Test {
 protected:
  glm::vec3 place(const char* bone) { return joint_by_definition(skeleton_, pose_.view(), bone).position; }

  FootPlacementJob job(float are_planted) {
    for (PlacedFoot& foot : feet_) foot.planted = are_planted;
    return {.rig = &rig_, .body = &body_, .feet = feet_, .pose = pose_.view(), .seconds = frame};
  }
  float stand_on(const Slope& slope, float are_planted) {
    for (PlacedFoot& foot : feet_) foot.ground = {.place = glm::vec3(0.0F), .normal = slope.normal};
    return place_feet(job(are_planted));
  }
  /// As if nobody had stood there before; the ground stays.
  void start_anew() {
    pose_ = HeldPose(skeleton_);
    forget_feet(job(planted));
  }
  /// Height of heel and ball of a foot above the ground, by the definition of the pose.
  std::pair<float, float> sole_above(const Slope& slope, std::size_t leg) {
    const JointMotion ankle = joint_by_definition(
        skeleton_, pose_.view(), rig_.legs[leg].limb.chain.bones[static_cast<std::size_t>(rig_.legs[leg].limb.end())]);
    return {slope.above(ankle.position + ankle.rotation * rig_.legs[leg].sole[0]),
            slope.above(ankle.position + under_toes(rig_.legs[leg], ankle.rotation, slope.normal))};
  }

  Skeleton skeleton_ = named_skeleton(person_joints());
  HeldPose pose_{skeleton_};
  FootPlacementRig rig_ =
      make_foot_placement_rig(skeleton_, std::vector{leg_bones(skeleton_, ".L"), leg_bones(skeleton_, ".R")}).value();
  PlacedBody body_;
  PlacedFoot feet_[2];
};

TEST_F(PersonOnGround, IsValidAsItsCommentsSay) {
  static const FootPlacementRig no_legs;
  static PlacedBody up_below_down, turned_too_long;
  up_below_down.options.up_above = 0.0F;
  turned_too_long.model_in_world.rotation.w = 2.0F;
  expect_validity<FootPlacementJob>(
      job(planted),
      {{false, "no rig", [](FootPlacementJob& job) { job.rig = nullptr; }},
       {false, "a rig without legs", [](FootPlacementJob& job) { job.rig = &no_legs; }},
       {false, "no body", [](FootPlacementJob& job) { job.body = nullptr; }},
       {false, "options that contradict each other", [](FootPlacementJob& job) { job.body = &up_below_down; }},
       {false, "a rotation that is not unit", [](FootPlacementJob& job) { job.body = &turned_too_long; }},
       {false, "no feet", [](FootPlacementJob& job) { job.feet = nullptr; }},
       {false, "no pose", [](FootPlacementJob& job) { job.pose.first = nullptr; }},
       {false, "a pose off the alignment", [](FootPlacementJob& job) { job.pose.first += 1; }},
       {false, "a pose with scale", [](FootPlacementJob& job) { job.pose.components = general_components; }},
       {false, "packets that overlap", [](FootPlacementJob& job) { job.pose.packet_stride = 100; }},
       {false, "a negative bone count", [](FootPlacementJob& job) { job.pose.bone_count = -1; }},
       {false, "a pelvis that cannot be lowered", [](FootPlacementJob& job) { job.pose.displaced_quads = 0; }},
       {true, "a level without legs",
        [](FootPlacementJob& job) { job.pose.bone_count = 1, job.pose.displaced_quads = 0; }},
       {true, "no time", [](FootPlacementJob& job) { job.seconds = 0.0F; }},
       {false, "time that goes back", [](FootPlacementJob& job) { job.seconds = -0.01F; }},
       {true, "weight 0", [](FootPlacementJob& job) { job.weight = 0.0F; }},
       {true, "weight 1", [](FootPlacementJob& job) { job.weight = 1.0F; }},
       {false, "weight below 0", [](FootPlacementJob& job) { job.weight = -0.01F; }},
       {false, "weight above 1", [](FootPlacementJob& job) { job.weight = 1.01F; }},
       {false, "weight not a number", [](FootPlacementJob& job) { job.weight = std::nanf(""); }}});
}

TEST_F(PersonOnGround, IsValidInStripsOfOneRig) {
  const FootPlacementRig other = rig_;
  std::vector<FootPlacementJob> jobs(3, job(planted));
  EXPECT_TRUE(is_valid(std::span<const FootPlacementJob>(jobs)));
  jobs.back().rig = &other;
  EXPECT_FALSE(is_valid(std::span<const FootPlacementJob>(jobs)));
}

TEST_F(PersonOnGround, StandsWithBothSolesOnASlopeOf20DegreesWhicheverWayItRises) {
  for (int direction = 0; direction < 8; ++direction) {
    const float angle = static_cast<float>(direction) * std::numbers::pi_v<float> / 4.0F;
    const Slope slope(20.0F, {std::sin(angle), 0.0F, std::cos(angle)});
    start_anew();
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
    start_anew();
    pose_.shake(random, 0.15F);
    stand_on(slope, planted);
    for (std::size_t leg = 0; leg < 2; ++leg) {
      if (feet_[leg].missed_by > 1e-3F) continue;
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
  EXPECT_LT(stand_on(Slope(0.0F, {1.0F, 0.0F, 0.0F}), planted), 1e-6F);
  EXPECT_LT(glm::distance(place("foot.L"), ankle), 1e-5F);
  EXPECT_LT(glm::distance(place("shin.L"), knee), 1e-4F);
}

TEST_F(PersonOnGround, LeavesThePoseToTheBitWithoutWeight) {
  const std::vector<float> before = pose_.floats();
  feet_[0].ground.place.y = -0.2F;
  FootPlacementJob none = job(planted);
  none.weight = 0.0F;
  EXPECT_EQ(place_feet(none), 0.0F);
  EXPECT_EQ(pose_.floats(), before);
  EXPECT_FALSE(body_.started);
  EXPECT_LT(glm::distance(feet_[0].ankle, place("foot.L")), 1e-6F)
      << "where the ground is to be looked for is known all the same";
}

TEST_F(PersonOnGround, LowersThePelvisForTheFootInAHoleAndNoFurtherThanAllowed) {
  feet_[0].ground.place.y = -0.15F;
  EXPECT_NEAR(place_feet(job(planted)), 0.15F, 0.02F);
  EXPECT_NEAR(place("foot.L").y, 0.08F - 0.15F, 1e-3F);
  EXPECT_NEAR(place("foot.R").y, 0.08F, 1e-3F) << "the other stays up";

  start_anew();
  feet_[0].ground.place.y = -5.0F;
  EXPECT_FLOAT_EQ(place_feet(job(planted)), 0.4F);
  EXPECT_GT(feet_[0].missed_by, 4.0F) << "and it says what it could not reach";
  EXPECT_LT(feet_[1].missed_by, 1e-3F);
}

TEST_F(PersonOnGround, LowersThePelvisSmoothly) {
  place_feet(job(planted));
  feet_[0].ground.place.y = -0.2F;
  for (PlacedFoot& foot : feet_) foot.lock = {};
  float last = 0.0F;
  for (int i = 0; i < 60; ++i) {
    pose_ = HeldPose(skeleton_);
    const float drop = place_feet(job(planted));
    EXPECT_GE(drop, last);
    EXPECT_LT(drop - last, 0.05F);
    last = drop;
  }
  EXPECT_NEAR(last, 0.2F, 0.02F);
}

TEST_F(PersonOnGround, CarriesLiftedFeetOverTheGroundAsHighAsThePoseDoes) {
  pose_.view().set_position(find_bone(skeleton_, "hips"), {0.0F, 0.1F, 0.0F});
  feet_[0].ground.place.y = feet_[1].ground.place.y = 0.2F;
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
    const float t = static_cast<float>(i) * frame;
    body_.model_in_world = {.rotation = glm::angleAxis(0.5F, glm::vec3(0.0F, 1.0F, 0.0F)),
                            .position = {40.0F + t, 0.0F, -30.0F - 0.5F * t}};
    place_feet(job(planted));
    if (i == 0) first = world_ankle(body_.model_in_world);
    EXPECT_LT(glm::distance(world_ankle(body_.model_in_world), first), 1e-4F) << i;
  }
  EXPECT_LT(feet_[0].lock.slid, 5e-4F);
  EXPECT_NEAR(feet_[0].lock.standing_seconds, 11.0F * frame, 1e-5F);
}

TEST_F(PersonOnGround, GivesAFootUpToABodyThatWalksAwayAndKeepsTheHips) {
  const float most_drop = told_lock_reserve * 0.9F;  // of a leg of 0.9 m
  bool stepped = false;
  glm::vec3 last(0.0F);
  for (int i = 0; i < 90; ++i) {
    pose_ = HeldPose(skeleton_);
    body_.model_in_world.position.z = static_cast<float>(std::min(i, 60)) * frame;
    EXPECT_LT(place_feet(job(planted)), most_drop) << i;
    EXPECT_LT(feet_[0].missed_by, 0.01F) << "the foot comes along: " << i;
    const glm::vec3 ankle = body_.model_in_world.position + place("foot.L");
    EXPECT_LT(i == 0 ? 0.0F : glm::distance(ankle, last), 0.06F) << "without a jump: " << i;
    last = ankle;
    stepped = stepped || ankle.y > 0.09F;
  }
  EXPECT_TRUE(stepped) << "and it is lifted on its way";
  EXPECT_TRUE(feet_[0].lock.locked());
  EXPECT_LT(glm::distance(place("foot.L"), glm::vec3(0.1F, 0.08F, 0.0F)), 0.24F)
      << "it stands again, where its leg reaches";
}

TEST_F(PersonOnGround, LowersThePelvisForAHoleThatALockedFootStandsIn) {
  feet_[0].ground.place.y = -0.15F;
  place_feet(job(planted));
  ASSERT_TRUE(feet_[0].lock.locked());
  for (PlacedFoot& foot : feet_) foot.ground.place.y = 0.0F;
  for (int i = 0; i < 30; ++i) {
    pose_ = HeldPose(skeleton_);
    body_.model_in_world.position.z += 0.001F;
    EXPECT_NEAR(place_feet(job(planted)), 0.15F, 0.02F) << "the ground is where the foot stands, not where the pose is";
  }
}

TEST_F(PersonOnGround, TellsHowFarFeetSlideThatAreNotLocked) {
  for (int i = 0; i < 12; ++i) {
    pose_ = HeldPose(skeleton_);
    body_.options.lock.enabled = false;
    body_.model_in_world.position.z = static_cast<float>(i) * frame;
    place_feet(job(planted));
  }
  EXPECT_NEAR(feet_[0].lock.slid, 11.0F * frame, 1e-4F);
}

TEST_F(PersonOnGround, StaysFiniteOnBrokenGround) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Footing& ground :
       {Footing{{0, nan, 0}, {0, 1, 0}}, Footing{{nan, 0, nan}, {0, 0.9F, 0.1F}}, Footing{{0, 0, 0}, glm::vec3(nan)},
        Footing{{0, 0, 0}, glm::vec3(0.0F)}, Footing{{0, 0, 0}, {0, -1, 0}}, Footing{{0, 1e8F, 0}, {1, 0, 0}}}) {
    start_anew();
    feet_[0].ground = ground;
    place_feet(job(planted));
    EXPECT_TRUE(std::isfinite(feet_[0].missed_by));
    EXPECT_TRUE(pose_.is_finite());
  }
}

TEST_F(PersonOnGround, IsLeftAloneInALevelOfDetailWithoutAllLegs) {
  const std::vector<float> before = pose_.floats();
  FootPlacementJob coarse = job(planted);
  coarse.pose.bone_count = find_bone(skeleton_, "foot.R");
  feet_[0].ground.place.y = -0.2F;
  EXPECT_EQ(place_feet(coarse), 0.0F);
  EXPECT_EQ(pose_.floats(), before);
}

TEST(FootPlacementRig, IsRefusedForLegsWhoseBonesLieInTooManyPlaces) {
  std::vector<NamedJoint> joints{{"pelvis", "", {0, 1, 0}}};
  std::vector<LegBones> legs;
  for (int leg = 0; leg < max_legs; ++leg) {
    std::string parent = "pelvis";
    for (int segment = 0; segment < 9; ++segment) {
      const std::string name = std::to_string(leg) + "." + std::to_string(segment);
      const glm::vec3 place(0.1F * static_cast<float>(leg), 0.9F - 0.1F * static_cast<float>(segment), 0.0F);
      joints.push_back({name, parent, place});
      for (const char* bristle : {"a", "b", "c"}) joints.push_back({name + bristle, name, place});
      parent = name;
    }
    const int hip = 1 + 36 * leg;
    legs.push_back({hip, hip + 16, hip + 32, -1});
  }
  EXPECT_THAT(make_foot_placement_rig(named_skeleton(joints), legs).error().message,
              HasSubstr("joints in 72 groups of four bones, of which feet are placed over at most 64"));
  legs.pop_back();
  EXPECT_TRUE(make_foot_placement_rig(named_skeleton(joints), legs));
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
}  // namespace throng::anim::foot_placement_test
