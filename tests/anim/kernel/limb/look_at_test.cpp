#include "engine/anim/kernel/limb/look_at.h"

#include <algorithm>
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

namespace throng::anim::look_at_test {
namespace {

using testing::HasSubstr;

constexpr float frame = 1.0F / 60.0F;

class PersonLooking : public testing::Test {
 protected:
  std::vector<LookBone> bones(std::initializer_list<std::pair<const char*, float>> named) const {
    std::vector<LookBone> list;
    for (const auto& [name, weight] : named) list.push_back({find_bone(skeleton_, name), weight});
    return list;
  }
  JointMotion joint(const char* bone) { return joint_by_definition(skeleton_, pose_.view(), bone); }
  glm::vec3 facing() { return joint("head").rotation * glm::vec3(0.0F, 0.0F, 1.0F); }
  float yaw() { return std::atan2(facing().x, facing().z); }
  float off(const glm::vec3& target) {
    const glm::vec3 way = glm::normalize(target - joint("head").position - joint("head").rotation * rig_.eyes);
    return std::acos(std::clamp(glm::dot(way, facing()), -1.0F, 1.0F));
  }
  LookAtJob job(const glm::vec3& target) {
    return {.rig = &rig_, .state = &state_, .pose = pose_.view(), .target = target, .seconds = frame};
  }
  /// Each frame the animation poses the bind pose anew.
  float look_for(int frames, const glm::vec3& target, float weight = 1.0F) {
    float remaining = 0.0F;
    for (int i = 0; i < frames; ++i) {
      pose_ = HeldPose(skeleton_);
      LookAtJob look = job(target);
      look.weight = weight;
      remaining = look_at(look);
    }
    return remaining;
  }

  Skeleton skeleton_ = named_skeleton(person_joints());
  HeldPose pose_{skeleton_};
  LookAtRig rig_ = make_look_at_rig(skeleton_, bones({{"spine", 1}, {"chest", 1}, {"neck", 2}, {"head", 4}}),
                                    {0.0F, 0.0F, 1.0F}, {0.0F, 0.1F, 0.08F})
                       .value();
  LookAtState state_;
};

TEST_F(PersonLooking, IsValidAsItsCommentsSay) {
  expect_validity<LookAtJob>(
      job({1.0F, 1.6F, 2.0F}),
      {{false, "no rig", [](LookAtJob& job) { job.rig = nullptr; }},
       {false, "no state", [](LookAtJob& job) { job.state = nullptr; }},
       {false, "no pose", [](LookAtJob& job) { job.pose.first = nullptr; }},
       {false, "a pose off the alignment", [](LookAtJob& job) { job.pose.first += 1; }},
       {false, "a pose with scale", [](LookAtJob& job) { job.pose.components = general_components; }},
       {false, "packets that overlap", [](LookAtJob& job) { job.pose.packet_stride = 100; }},
       {false, "a negative bone count", [](LookAtJob& job) { job.pose.bone_count = -1; }},
       {true, "a target that is no place", [](LookAtJob& job) { job.target.x = std::nanf(""); }},
       {true, "no time", [](LookAtJob& job) { job.seconds = 0.0F; }},
       {false, "time that goes back", [](LookAtJob& job) { job.seconds = -0.01F; }},
       {false, "a yaw of half a turn", [](LookAtJob& job) { job.limits.yaw = std::numbers::pi_v<float>; }},
       {false, "a pitch of a quarter turn", [](LookAtJob& job) { job.limits.pitch_up = 1.6F; }},
       {false, "a negative pitch", [](LookAtJob& job) { job.limits.pitch_down = -0.1F; }},
       {true, "turns at once", [](LookAtJob& job) { job.limits.smooth_seconds = 0.0F; }},
       {false, "a negative smooth time", [](LookAtJob& job) { job.limits.smooth_seconds = -0.1F; }},
       {true, "weight 0", [](LookAtJob& job) { job.weight = 0.0F; }},
       {true, "weight 1", [](LookAtJob& job) { job.weight = 1.0F; }},
       {false, "weight below 0", [](LookAtJob& job) { job.weight = -0.01F; }},
       {false, "weight above 1", [](LookAtJob& job) { job.weight = 1.01F; }},
       {false, "weight not a number", [](LookAtJob& job) { job.weight = std::nanf(""); }}});
}

TEST_F(PersonLooking, IsValidInStripsOfOneRig) {
  const LookAtRig other = rig_;
  std::vector<LookAtJob> jobs(widest_strip, job({1.0F, 1.6F, 2.0F}));
  EXPECT_TRUE(is_valid(std::span<const LookAtJob>(jobs)));
  jobs.push_back(jobs.front());
  EXPECT_FALSE(is_valid(std::span<const LookAtJob>(jobs)));
  jobs.pop_back();
  jobs.back().rig = &other;
  EXPECT_FALSE(is_valid(std::span<const LookAtJob>(jobs)));
}

TEST_F(PersonLooking, SettlesOnATargetExactly) {
  std::mt19937 random(31);
  for (int i = 0; i < 50; ++i) {
    const float side = random_between(random, -1.0F, 1.0F);
    const glm::vec3 target(3.0F * std::sin(side), 1.5F + random_between(random, -0.8F, 0.8F), 3.0F * std::cos(side));
    state_ = {};
    const float remaining = look_for(180, target);
    EXPECT_LT(off(target), 2e-3F);
    EXPECT_NEAR(remaining, off(target), 1e-3F);
  }
}

TEST_F(PersonLooking, SharesTheTurnAmongTheJoints) {
  look_for(180, {30.0F, 1.65F, 30.0F});
  const auto turned = [&](const char* bone) {
    const glm::vec3 ahead = joint(bone).rotation * glm::vec3(0.0F, 0.0F, 1.0F);
    return std::atan2(ahead.x, ahead.z);
  };
  EXPECT_NEAR(turned("head"), 0.785F, 0.02F);
  EXPECT_NEAR(turned("spine"), turned("head") / 8.0F, 1e-4F);
  EXPECT_NEAR(turned("chest"), turned("head") / 4.0F, 1e-4F);
  EXPECT_NEAR(turned("neck"), turned("head") / 2.0F, 1e-4F);
  EXPECT_NEAR(turned("hips"), 0.0F, 1e-6F);
}

TEST_F(PersonLooking, TurnsFromTheBodyThatCarriesIt) {
  pose_.view().set_rotation(find_bone(skeleton_, "hips"), glm::angleAxis(0.9F, glm::vec3(0.0F, 1.0F, 0.0F)));
  LookAtJob look = job({10.0F, 1.65F, 0.0F});
  look.limits.smooth_seconds = 0.0F;
  look_at(look);
  EXPECT_LT(off({10.0F, 1.65F, 0.0F}), 0.02F) << "1.57 from the front is within the limit of 1.3 from these hips";
}

TEST_F(PersonLooking, KeepsATargetNearbyInViewWhileTheNeckMoves) {
  // Eyes count from where the last frame left them: a head that nods this fast has moved them by a few millimetres.
  const glm::vec3 target{0.4F, 1.5F, 1.0F};
  look_for(180, target);
  for (int i = 0; i < 120; ++i) {
    pose_ = HeldPose(skeleton_);
    const float nod = 0.3F * std::sin(6.0F * static_cast<float>(i) * frame);
    pose_.view().set_rotation(find_bone(skeleton_, "neck"), glm::angleAxis(nod, glm::vec3(1.0F, 0.0F, 0.0F)));
    LookAtJob look = job(target);
    look.limits.smooth_seconds = 0.0F;
    look_at(look);
    EXPECT_LT(off(target), 0.01F) << i;
  }
}

TEST_F(PersonLooking, StopsAtItsLimits) {
  look_for(180, {10.0F, 1.65F, -2.0F});
  EXPECT_NEAR(yaw(), 1.3F, 1e-3F);
  look_for(180, {0.0F, 50.0F, 1.0F});
  EXPECT_NEAR(std::asin(facing().y), 0.7F, 1e-3F);
  look_for(180, {0.0F, -50.0F, 1.0F});
  EXPECT_NEAR(std::asin(facing().y), -0.7F, 1e-3F);
}

TEST_F(PersonLooking, KeepsItsShoulderForATargetThatWandersBehind) {
  look_for(180, {4.0F, 1.6F, -2.0F});
  for (int i = 0; i < 600; ++i) {
    look_for(1, {1.5F * std::sin(0.1F * static_cast<float>(i)), 1.6F, -4.0F});
    EXPECT_GT(yaw(), 1.2F) << i;
  }
}

TEST_F(PersonLooking, NeverTurnsFasterThanItsSmoothingAllows) {
  look_for(1, {0.0F, 1.6F, 5.0F});
  float last = yaw();
  for (int i = 0; i < 400; ++i) {
    const float angle = 0.05F * static_cast<float>(i);  // round and round, past the back too
    look_for(1, {5.0F * std::sin(angle), 1.6F, 5.0F * std::cos(angle)});
    EXPECT_LT(std::fabs(yaw() - last), 0.25F) << i;
    EXPECT_LE(std::fabs(yaw()), 1.31F);
    last = yaw();
  }
}

TEST_F(PersonLooking, StartsWhereThePoseLooks) {
  look_for(1, {5.0F, 1.6F, 5.0F});
  EXPECT_LT(yaw(), 0.1F);
}

TEST_F(PersonLooking, LeavesThePoseToTheBitWithoutWeight) {
  std::mt19937 random(32);
  pose_.shake(random, 0.3F);
  const std::vector<float> before = pose_.floats();
  LookAtJob look = job({5.0F, 1.6F, 5.0F});
  look.weight = 0.0F;
  look_at(look);
  EXPECT_EQ(pose_.floats(), before);
}

TEST_F(PersonLooking, TurnsHalfOfTheWayWithHalfTheWeight) {
  look_for(180, {30.0F, 1.65F, 30.0F}, 0.5F);
  EXPECT_NEAR(yaw(), 0.785F / 2.0F, 0.02F);
}

TEST_F(PersonLooking, StaysFiniteWhateverItLooksAt) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const glm::vec3 eyes = joint("head").position + rig_.eyes;
  for (const glm::vec3& target : {eyes, eyes + glm::vec3(0.0F, 2.0F, 0.0F), eyes - glm::vec3(0.0F, 0.0F, 2.0F),
                                  glm::vec3(1e20F), glm::vec3(nan)}) {
    EXPECT_TRUE(std::isfinite(look_for(3, target)));
    EXPECT_TRUE(pose_.is_finite());
  }
}

TEST_F(PersonLooking, IsRefusedForBonesThatAreNoChain) {
  EXPECT_THAT(make_look_at_rig(skeleton_, {}).error().message, HasSubstr("name 1 to 8 bones, not 0"));
  EXPECT_THAT(make_look_at_rig(skeleton_, bones({{"neck", 1}, {"chest", 1}, {"head", 1}})).error().message,
              HasSubstr("is not between the bone before it and the head"));
  EXPECT_THAT(make_look_at_rig(skeleton_, bones({{"neck", 0}, {"head", 1}})).error().message,
              HasSubstr("has no weight above 0"));
  EXPECT_THAT(make_look_at_rig(skeleton_, bones({{"head", 1}}), {0.0F, 1.0F, 0.0F}).error().message,
              HasSubstr("points straight up or down"));
}

}  // namespace
}  // namespace throng::anim::look_at_test
