#include "engine/anim/kernel/limb/two_bone_ik.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/bone_mask.h"
#include "tests/anim/kernel/limb/one_character.h"
#include "tests/anim/kernel/pose/held_pose.h"
#include "tests/anim/kernel/validity.h"
#include "tests/anim/rig/named_skeleton.h"

namespace throng::anim::two_bone_ik_test {
namespace {

using testing::HasSubstr;

constexpr glm::vec3 ahead{0.0F, 0.0F, 1.0F};

/// Hip 1.1 m above the ground, knee and ankle straight below it, with a twist bone in the thigh.
std::vector<NamedJoint> straight_leg() {
  return {{"hip", "", {0, 1.1F, 0}},
          {"twist", "hip", {0, 0.8F, 0}},
          {"knee", "twist", {0, 0.6F, 0}},
          {"ankle", "knee", {0, 0.1F, 0}}};
}

class TwoBoneIk : public testing::Test {
 protected:
  explicit TwoBoneIk(const std::vector<NamedJoint>& joints = person_joints(), const char* upper = "thigh.L",
                     const char* middle = "shin.L", const char* end = "foot.L")
      : skeleton_(named_skeleton(joints)), upper_(upper), middle_(middle), end_(end) {}

  glm::vec3 place(const char* bone) { return joint_by_definition(skeleton_, pose_.view(), bone).position; }
  float first_length() { return glm::distance(place(upper_), place(middle_)); }
  float second_length() { return glm::distance(place(middle_), place(end_)); }
  TwoBoneIkJob job(const glm::vec3& target) { return {.limb = &limb_, .pose = pose_.view(), .target = target}; }

  Skeleton skeleton_;
  const char* upper_;
  const char* middle_;
  const char* end_;
  HeldPose pose_{skeleton_};
  TwoBoneLimb limb_ = make_two_bone_limb(skeleton_, find_bone(skeleton_, upper_), find_bone(skeleton_, middle_),
                                         find_bone(skeleton_, end_), ahead)
                          .value();
};

class StraightLeg : public TwoBoneIk {
 protected:
  StraightLeg() : TwoBoneIk(straight_leg(), "hip", "knee", "ankle") {}
};

TEST_F(TwoBoneIk, IsValidAsItsCommentsSay) {
  expect_validity<TwoBoneIkJob>(
      job({0.1F, 0.3F, 0.2F}),
      {{false, "no limb", [](TwoBoneIkJob& job) { job.limb = nullptr; }},
       {false, "no pose", [](TwoBoneIkJob& job) { job.pose.first = nullptr; }},
       {false, "a pose off the alignment", [](TwoBoneIkJob& job) { job.pose.first += 1; }},
       {false, "a pose with scale", [](TwoBoneIkJob& job) { job.pose.components = general_components; }},
       {false, "packets that overlap", [](TwoBoneIkJob& job) { job.pose.packet_stride = 100; }},
       {false, "a negative bone count", [](TwoBoneIkJob& job) { job.pose.bone_count = -1; }},
       {true, "a target that is no place", [](TwoBoneIkJob& job) { job.target.x = std::nanf(""); }},
       {true, "weight 0", [](TwoBoneIkJob& job) { job.weight = 0.0F; }},
       {true, "weight 1", [](TwoBoneIkJob& job) { job.weight = 1.0F; }},
       {false, "weight below 0", [](TwoBoneIkJob& job) { job.weight = -0.01F; }},
       {false, "weight above 1", [](TwoBoneIkJob& job) { job.weight = 1.01F; }},
       {false, "weight not a number", [](TwoBoneIkJob& job) { job.weight = std::nanf(""); }},
       {true, "softness of a half", [](TwoBoneIkJob& job) { job.softness = 0.5F; }},
       {false, "too much softness", [](TwoBoneIkJob& job) { job.softness = 0.6F; }},
       {false, "negative softness", [](TwoBoneIkJob& job) { job.softness = -0.1F; }},
       {true, "an end rotation that is not asked for", [](TwoBoneIkJob& job) { job.end_rotation *= 2.0F; }},
       {false, "an end rotation that is not unit",
        [](TwoBoneIkJob& job) { job.turn_end = true, job.end_rotation *= 2.0F; }}});
}

TEST_F(TwoBoneIk, IsValidInStripsOfOneLimb) {
  const TwoBoneLimb other = limb_;
  std::vector<TwoBoneIkJob> jobs(3, job({0.1F, 0.3F, 0.2F}));
  EXPECT_TRUE(is_valid(std::span<const TwoBoneIkJob>(jobs)));
  jobs.back().limb = &other;
  EXPECT_FALSE(is_valid(std::span<const TwoBoneIkJob>(jobs)));
}

TEST_F(TwoBoneIk, ReachesAThousandTargetsAndKeepsTheLengthsOfBones) {
  std::mt19937 random(11);
  for (int i = 0; i < 1000; ++i) {
    pose_ = HeldPose(skeleton_);
    pose_.shake(random, 0.6F);
    const float first = first_length();
    const float second = second_length();
    const glm::vec3 target = place("thigh.L") + random_direction(random) * random_between(random, 0.05F, 0.83F);
    TwoBoneIkJob reach = job(target);
    if (i % 2 == 0) reach.pole = random_direction(random);
    EXPECT_LT(solve_two_bone_ik(reach), 1e-3F);
    EXPECT_LT(glm::distance(place("foot.L"), target), 1e-3F);
    EXPECT_NEAR(first_length(), first, 1e-5F);
    EXPECT_NEAR(second_length(), second, 1e-5F);
  }
}

TEST_F(StraightLeg, BendsByTheLawOfCosines) {
  // Both halves are 0.5 m: at a distance of sqrt(0.5) m they stand at a right angle.
  solve_two_bone_ik(job({0.0F, 1.1F - std::sqrt(0.5F), 0.0F}));
  EXPECT_NEAR(glm::dot(place("knee") - place("hip"), place("ankle") - place("knee")), 0.0F, 1e-6F);
}

TEST_F(StraightLeg, BendsTheWayItWasMadeToBend) {
  solve_two_bone_ik(job({0.0F, 0.4F, 0.0F}));
  EXPECT_GT(place("knee").z, 0.2F);
  EXPECT_NEAR(place("knee").x, 0.0F, 1e-6F);
}

TEST_F(StraightLeg, CarriesTheBonesBetween) {
  const float to_knee = glm::distance(place("twist"), place("knee"));
  solve_two_bone_ik(job({0.1F, 0.4F, 0.2F}));
  EXPECT_NEAR(glm::distance(place("twist"), place("knee")), to_knee, 1e-6F);
  EXPECT_NEAR(glm::length(glm::cross(place("twist") - place("hip"), place("knee") - place("hip"))), 0.0F, 1e-6F);
}

TEST_F(StraightLeg, PointsTheMiddleAlongThePole) {
  TwoBoneIkJob reach = job({0.2F, 0.4F, 0.0F});
  reach.pole = {1.0F, 0.0F, 0.0F};
  solve_two_bone_ik(reach);
  EXPECT_NEAR(place("knee").z, 0.0F, 1e-6F);
  EXPECT_GT(place("knee").x, 0.2F);
  EXPECT_LT(glm::distance(place("ankle"), {0.2F, 0.4F, 0.0F}), 1e-5F);
}

TEST_F(StraightLeg, StretchesTowardsATargetOutOfReach) {
  const glm::vec3 target(3.0F, 2.0F, 1.0F);
  const float missed_by = solve_two_bone_ik(job(target));
  const glm::vec3 reached = place("ankle") - place("hip");
  EXPECT_NEAR(glm::length(reached), 1.0F, 1e-5F) << "it was straight before";
  EXPECT_NEAR(missed_by, glm::distance(target, place("hip")) - 1.0F, 1e-5F);
  EXPECT_NEAR(glm::dot(glm::normalize(reached), glm::normalize(target - place("hip"))), 1.0F, 1e-6F);
}

/// Largest way of the knee while the target moves off a millimetre at a time, for a leg that is bent to begin with.
float largest_step_of_the_knee(float softness, const Skeleton& skeleton, const TwoBoneLimb& limb) {
  float largest = 0.0F;
  glm::vec3 last(0.0F);
  for (int millimetre = 0; millimetre < 100; ++millimetre) {
    HeldPose pose(skeleton);
    solve_two_bone_ik({.limb = &limb, .pose = pose.view(), .target = {0.0F, 0.3F, 0.0F}});
    const float distance = 0.95F + 0.001F * static_cast<float>(millimetre);
    solve_two_bone_ik(
        {.limb = &limb, .pose = pose.view(), .target = {0.0F, 1.1F - distance, 0.0F}, .softness = softness});
    const glm::vec3 knee = joint_by_definition(skeleton, pose.view(), "knee").position;
    if (millimetre > 0) largest = std::max(largest, glm::distance(knee, last));
    last = knee;
  }
  return largest;
}

TEST_F(StraightLeg, DoesNotSnapStraightWhenItsReachIsSoft) {
  EXPECT_GT(largest_step_of_the_knee(0.0F, skeleton_, limb_), 0.02F);
  EXPECT_LT(largest_step_of_the_knee(0.05F, skeleton_, limb_), 0.005F);
}

TEST_F(TwoBoneIk, LeavesThePoseToTheBitWithoutWeight) {
  std::mt19937 random(12);
  pose_.shake(random, 0.6F);
  const std::vector<float> before = pose_.floats();
  TwoBoneIkJob reach = job({0.0F, 0.5F, 0.3F});
  reach.weight = 0.0F;
  reach.turn_end = true;
  EXPECT_GT(solve_two_bone_ik(reach), 0.1F);
  EXPECT_EQ(pose_.floats(), before);
}

TEST_F(TwoBoneIk, GetsNearerTheMoreItWeighs) {
  const glm::vec3 target(0.2F, 0.5F, 0.3F);
  float last = glm::distance(place("foot.L"), target);
  for (const float weight : {0.01F, 0.25F, 0.5F, 0.75F, 1.0F}) {
    pose_ = HeldPose(skeleton_);
    TwoBoneIkJob reach = job(target);
    reach.weight = weight;
    const float missed_by = solve_two_bone_ik(reach);
    EXPECT_LT(missed_by, last);
    EXPECT_NEAR(missed_by, glm::distance(place("foot.L"), target), 1e-6F);
    last = missed_by;
  }
  EXPECT_LT(last, 1e-5F);
}

TEST_F(TwoBoneIk, LeavesALimbThatIsThereAlready) {
  std::mt19937 random(13);
  for (int i = 0; i < 100; ++i) {
    pose_ = HeldPose(skeleton_);
    pose_.shake(random, 0.1F);
    const glm::vec3 knee = place("shin.L");
    const JointMotion foot = joint_by_definition(skeleton_, pose_.view(), "foot.L");
    solve_two_bone_ik(job(foot.position));
    EXPECT_LT(glm::distance(place("foot.L"), foot.position), 1e-5F);
    EXPECT_LT(glm::distance(place("shin.L"), knee), 1e-4F);
  }
}

TEST_F(TwoBoneIk, TurnsTheEndWhereItIsAskedTo) {
  const glm::quat wanted = glm::angleAxis(0.4F, glm::normalize(glm::vec3(1.0F, 0.5F, 0.0F)));
  TwoBoneIkJob reach = job({0.15F, 0.3F, 0.2F});
  reach.turn_end = true;
  reach.end_rotation = wanted;
  solve_two_bone_ik(reach);
  EXPECT_LT(angle_between(joint_by_definition(skeleton_, pose_.view(), "foot.L").rotation, wanted), 2e-6F);
}

TEST_F(TwoBoneIk, StaysFiniteWhateverItIsGiven) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const glm::vec3 hip = place("thigh.L");
  for (const glm::vec3& target :
       {hip, hip + glm::vec3(1e-7F), hip + glm::vec3(0.0F, -0.5F, 0.0F), glm::vec3(1e20F), glm::vec3(nan)}) {
    for (const glm::vec3& pole : {glm::vec3(0.0F), target - hip, hip - target, glm::vec3(nan)}) {
      pose_ = HeldPose(skeleton_);
      TwoBoneIkJob reach = job(target);
      reach.pole = pole;
      EXPECT_TRUE(std::isfinite(solve_two_bone_ik(reach)));
      EXPECT_TRUE(pose_.is_finite());
    }
  }
}

TEST_F(StraightLeg, LeavesAThighOfNoLengthAlone) {
  for (const char* bone : {"twist", "knee"}) {
    const int index = find_bone(skeleton_, bone);
    const auto origin = [&](int b) { return glm::vec3(skeleton_.references[static_cast<std::size_t>(b)].origin); };
    pose_.view().set_position(index, origin(index - 1) - origin(index));
  }
  const std::vector<float> before = pose_.floats();
  EXPECT_TRUE(std::isfinite(solve_two_bone_ik(job({0.0F, 0.4F, 0.0F}))));
  EXPECT_EQ(pose_.floats(), before);
}

TEST_F(TwoBoneIk, LeavesALevelOfDetailWithoutTheFootAlone) {
  const std::vector<float> before = pose_.floats();
  TwoBoneIkJob reach = job({0.0F, 0.5F, 0.3F});
  reach.pose.bone_count = find_bone(skeleton_, "foot.L");
  EXPECT_EQ(solve_two_bone_ik(reach), 0.0F);
  EXPECT_EQ(pose_.floats(), before);
}

TEST_F(TwoBoneIk, IsRefusedForBonesThatAreNoLimb) {
  const auto bone = [this](const char* name) { return find_bone(skeleton_, name); };
  const auto swapped = make_two_bone_limb(skeleton_, bone("shin.L"), bone("thigh.L"), bone("foot.L"), ahead);
  EXPECT_THAT(swapped.error().message, HasSubstr("not one below the other"));
  const auto other_leg = make_two_bone_limb(skeleton_, bone("thigh.R"), bone("shin.L"), bone("foot.L"), ahead);
  EXPECT_THAT(other_leg.error().message, HasSubstr("not one below the other"));
  skeleton_.references[static_cast<std::size_t>(bone("shin.L"))].origin =
      skeleton_.references[static_cast<std::size_t>(bone("thigh.L"))].origin;
  const auto no_thigh = make_two_bone_limb(skeleton_, bone("thigh.L"), bone("shin.L"), bone("foot.L"), ahead);
  EXPECT_THAT(no_thigh.error().message, HasSubstr("two joints at the same place"));
}

}  // namespace
}  // namespace throng::anim::two_bone_ik_test
