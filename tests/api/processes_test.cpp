// What changes an agent's final pose.

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/anim/agent/heard_misuses.h"
#include "tests/api/api_crowd.h"

namespace throng::processes_test {
namespace {

using anim::HeardMisuses;
using api_test::ApiCrowd;
using api_test::mannequin;

float distance(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

ApiCrowd idling(std::uint32_t agents = 1) {
  ApiCrowd crowd(agents);
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    crowd.agent(agent).play({.clip = mannequin().find_clip("idle")});
  }
  return crowd;
}

TEST(ApiProcesses, AHandReachesWhereASocketSaysThatItIs) {
  ApiCrowd crowd = idling();
  const Agent agent = crowd.agent(0);
  const auto reach = agent.add(Reach{.limb = Limb::right_arm});
  const auto socket = agent.add(Socket{.bone = *mannequin().find_bone("hand.R")});
  ASSERT_TRUE(reach);
  ASSERT_TRUE(socket);
  crowd.step();
  Vec3 target = agent.processes().socket(*socket).position;
  target.y += 0.2F;
  EXPECT_TRUE(agent.processes().reach(*reach, target));
  EXPECT_TRUE(agent.processes().set_weight(*reach, 1.0F));
  crowd.step(2);
  EXPECT_LT(distance(agent.processes().socket(*socket).position, target), 0.01F);
}

TEST(ApiJoints, AreWhereSocketsSay) {
  ApiCrowd crowd = idling();
  const int hand = *mannequin().find_bone("hand.R");
  const auto socket = crowd.agent(0).add(Socket{.bone = hand});
  ASSERT_TRUE(socket);
  ASSERT_TRUE(crowd->write_joints(0, {.bones = {&hand, 1}}));
  ASSERT_EQ(crowd->joint_bytes(0), 32U);
  struct alignas(32) Joint {
    Quat rotation;
    Vec3 position;
    float scale;
  } joint;
  const PoseRequest request{.agent = crowd.agent(0).id(), .joints = reinterpret_cast<std::byte*>(&joint)};
  crowd->advance(ticks_per_second / 7);
  crowd->update({&request, 1});
  EXPECT_LT(distance(joint.position, crowd.agent(0).processes().socket(*socket).position), 1e-4F);
  const int beyond = 1000;
  EXPECT_FALSE(crowd->write_joints(0, {.bones = {&beyond, 1}}));
  EXPECT_FALSE(crowd->write_joints(0, {.skin = 99}));
}

TEST(ApiJoints, OfASkinArePalettesInItsOrder) {
  ApiCrowd crowd = idling();
  ASSERT_TRUE(crowd->write_joints(0, {.skin = 0, .format = JointFormat::matrices_4x4}));
  EXPECT_EQ(crowd->joint_bytes(0) % 64, 0U);
  EXPECT_GT(crowd->joint_bytes(0), std::size_t{64} * 50);
}

TEST(ApiJoints, LocalTransformsAreThoseOfEachBone) {
  const HeardMisuses heard;
  ApiCrowd crowd = idling();
  crowd.step();
  std::vector<LocalTransform> locals(static_cast<std::size_t>(mannequin().bone_count()));
  ASSERT_TRUE(crowd->local_pose(crowd.agent(0).id(), locals));
  for (const LocalTransform& local : locals) {
    EXPECT_NEAR(
        std::hypot(std::hypot(local.rotation.x, local.rotation.y), std::hypot(local.rotation.z, local.rotation.w)),
        1.0F, 1e-4F);
    EXPECT_EQ(local.scale, (Vec3{1.0F, 1.0F, 1.0F}));
  }
  EXPECT_FALSE(crowd->local_pose(crowd.agent(0).id(), std::span(locals).first(3)));
}

TEST(ApiProcesses, AHeadTurnsTowardsWhatItLooksAt) {
  ApiCrowd crowd = idling(2);
  const auto gaze = crowd.agent(1).add(LookAt{.smooth_seconds = 0.0F});
  ASSERT_TRUE(gaze);
  const int head = *mannequin().find_bone("head");
  EXPECT_TRUE(crowd.agent(1).processes().look_at(*gaze, {3.0F, 1.6F, 3.0F}));
  crowd.step(3);
  const auto entry = std::size_t{12} * static_cast<std::size_t>(head);
  // The third column of a rotation is where the head's +Z, its face, points to.
  const float ahead = crowd.palette({.number = 0})[entry + 2];
  const float aside = crowd.palette({.number = 1})[entry + 2];
  EXPECT_GT(aside, ahead + 0.4F) << "half a right angle to the left";
  EXPECT_TRUE(crowd.agent(1).processes().look_away(*gaze, {}));
}

TEST(ApiProcesses, ARagdollLiesDownWhenItIsPushed) {
  ApiCrowd crowd = idling();
  const auto fall = crowd.agent(0).add(Ragdoll{});
  const auto socket = crowd.agent(0).add(Socket{.bone = *mannequin().find_bone("head")});
  ASSERT_TRUE(fall && socket);
  crowd.step();
  const float standing = crowd.agent(0).processes().socket(*socket).position.y;
  EXPECT_FALSE(crowd.agent(0).processes().is_down(*fall));
  EXPECT_TRUE(crowd.agent(0).processes().push(*fall, {0.0F, 0.0F, 120.0F}, {0.0F, 1.3F, 0.0F}));
  crowd.step(120);
  EXPECT_TRUE(crowd.agent(0).processes().is_down(*fall));
  EXPECT_LT(crowd.agent(0).processes().socket(*socket).position.y, 0.5F * standing);
}

TEST(ApiProcesses, AStepOfTheHostsOwnChangesThePoseAndRemembers) {
  struct Memory {
    std::int64_t ticks;
  };
  const auto run = [](const StepJob& job) {
    reinterpret_cast<Memory*>(job.memory)->ticks += job.delta.count();
    const float half = 0.25F * static_cast<float>(to_seconds(Ticks{reinterpret_cast<Memory*>(job.memory)->ticks}));
    job.pose.set_rotation(0, {0.0F, std::sin(half), 0.0F, std::cos(half)});
    job.pose.set_rotation(5000, {});  // a bone that there is not
  };
  ApiCrowd crowd = idling(2);
  const auto step = crowd->add_step(0, {.name = "turn", .memory_bytes = sizeof(Memory), .run = run});
  ASSERT_TRUE(step);
  ASSERT_TRUE(crowd.agent(1).add(*step));
  const auto socket = crowd.agent(1).add(Socket{.bone = 0});
  ASSERT_TRUE(socket);
  crowd.step(120);
  const Quat turned = crowd.agent(1).processes().socket(*socket).rotation;
  EXPECT_NEAR(2.0F * std::atan2(std::abs(turned.y), turned.w), 1.0F, 0.05F) << "half a radian a second for two";
}

TEST(ApiProcesses, AStepThatSetsWhatIsNoNumberIsAMisuseAndLeavesTheBone) {
  const auto run = [](const StepJob& job) {
    job.pose.set_rotation(0, {NAN, 0.0F, 0.0F, 1.0F});
    job.pose.set_rotation(1, {0.0F, 0.0F, 0.0F, 0.0F});
    job.pose.set_position(0, {0.0F, INFINITY, 0.0F});
  };
  ApiCrowd crowd = idling(2);
  const auto step = crowd->add_step(0, {.name = "lost", .run = run});
  ASSERT_TRUE(step);
  ASSERT_TRUE(crowd.agent(1).add(*step));
  const HeardMisuses heard;
  crowd.step();
  EXPECT_EQ(heard.all(), (std::vector<std::string>{"StepPose::set_rotation: a rotation is a unit quaternion",
                                                   "StepPose::set_rotation: a rotation is a unit quaternion",
                                                   "StepPose::set_position: a position is of finite metres"}));
  const std::size_t floats = std::size_t{12} * mannequin().palette_entries();
  EXPECT_TRUE(std::equal(crowd.palette({0}), crowd.palette({0}) + floats, crowd.palette({1})));
}

TEST(ApiProcesses, RefuseWhatTheyAreNot) {
  const HeardMisuses heard;
  ApiCrowd crowd = idling();
  const auto gaze = crowd.agent(0).add(LookAt{});
  ASSERT_TRUE(gaze);
  EXPECT_FALSE(crowd.agent(0).processes().reach(*gaze, {}));
  EXPECT_FALSE(crowd.agent(0).processes().set_weight({7}, 1.0F));
  EXPECT_FALSE(crowd.agent(0).add(StepId{.character = 0, .number = 3}));
  EXPECT_FALSE(crowd.agent(0).add(ChainReach{.first = "no", .last = "bones"}));
  EXPECT_FALSE(crowd.agent(0).add(Socket{.bone = -1}));
  EXPECT_FALSE(crowd->add_step(0, {.name = "nothing"}));
  EXPECT_EQ(crowd.agent(0).processes().socket(*gaze).position, Vec3{});
  crowd.step(3);
}

TEST(ApiProcesses, ReturnFalseForWhatTheyReport) {
  const HeardMisuses heard;
  ApiCrowd crowd = idling();
  const Agent agent = crowd.agent(0);
  const auto gaze = agent.add(LookAt{});
  const auto fall = agent.add(Ragdoll{});
  ASSERT_TRUE(gaze && fall);
  EXPECT_FALSE(agent.processes().set_weight(*gaze, 2.0F));
  EXPECT_TRUE(agent.processes().look_at(*gaze, {}));
  EXPECT_FALSE(agent.processes().look_away(*gaze, Ticks{-1}));
  EXPECT_FALSE(agent.processes().push(*fall, {NAN, 0.0F, 0.0F}, {}));
  EXPECT_FALSE(agent.processes().recover(*fall, Ticks{-1}));
  const BlendPoint idle{.clip = mannequin().find_clip("idle")};
  const auto space = agent.add(BlendSpace{.points = {&idle, 1}});
  ASSERT_TRUE(space);
  EXPECT_FALSE(agent.set_parameter(*space, NAN));
  EXPECT_EQ(HeardMisuses::all().size(), 5U);
  EXPECT_EQ(agent.add(BlendSpace{.points = {&idle, 1}, .parameter = NAN}).error().message,
            "Agent::add: the parameter of a blend space is a finite number");
}

TEST(ApiProcesses, RefuseATargetThatIsNoNumberAndAFadeIntoThePast) {
  const HeardMisuses heard;
  ApiCrowd crowd = idling();
  const Processes processes = crowd.agent(0).processes();
  const auto gaze = crowd.agent(0).add(LookAt{}), arm = crowd.agent(0).add(Reach{});
  const auto feet = crowd.agent(0).add(FootPlacement{});
  ASSERT_TRUE(gaze && arm && feet);
  EXPECT_FALSE(processes.look_at(*gaze, {NAN, 0.0F, 0.0F}));
  EXPECT_FALSE(processes.look_at(*gaze, {}, Ticks{-1}));
  EXPECT_FALSE(processes.reach(*arm, {0.0F, NAN, 0.0F}));
  EXPECT_FALSE(processes.set_placement(*feet, {.position = {0.0F, 0.0F, NAN}}));
  EXPECT_FALSE(processes.set_placement(*feet, {.rotation = {0.0F, 0.0F, 0.0F, 0.0F}}));
  EXPECT_FALSE(processes.set_ground(*feet, 99, {}, {0.0F, 1.0F, 0.0F}));
  EXPECT_EQ(heard.all().size(), 6U);
}

TEST(ApiProcesses, AHeadTurnsBySmallStepsWhereAGazeFades) {
  ApiCrowd crowd = idling(2);
  const Vec3 target{3.0F, 1.6F, 3.0F};
  for (const AgentId agent : crowd->agents()) {
    const auto gaze = crowd->agent(agent).add(LookAt{.smooth_seconds = 0.0F});
    ASSERT_TRUE(gaze);
    EXPECT_TRUE(crowd->agent(agent).processes().look_at(*gaze, target, agent.number == 0 ? Ticks{} : ticks_per_second));
  }
  crowd.step(3);
  const auto face = std::size_t{12} * static_cast<std::size_t>(*mannequin().find_bone("head")) + 2;
  EXPECT_GT(crowd.palette({.number = 0})[face], crowd.palette({.number = 1})[face] + 0.2F);
}

TEST(ApiProcesses, TheGroundOfOneLegLeavesTheOther) {
  ApiCrowd crowd = idling();
  const Agent agent = crowd.agent(0);
  const auto feet = agent.add(FootPlacement{});
  const auto left = agent.add(Socket{.bone = *mannequin().find_bone("foot.L")});
  const auto right = agent.add(Socket{.bone = *mannequin().find_bone("foot.R")});
  ASSERT_TRUE(feet && left && right);
  EXPECT_TRUE(agent.processes().set_ground(*feet, 1, {0.0F, 0.15F, 0.0F}, {0.0F, 1.0F, 0.0F}));
  crowd.step(60);
  const Vec3 a = agent.processes().socket(*left).position, b = agent.processes().socket(*right).position;
  const Vec3 &higher = a.y > b.y ? a : b, &lower = a.y > b.y ? b : a;
  EXPECT_NEAR(higher.y - lower.y, 0.15F, 0.03F);
  EXPECT_NEAR(agent.processes().ankle(*feet, 1).x, higher.x, 0.03F);
}

TEST(ApiProcesses, RefuseAGroundWhoseNormalIsNotOfLengthOne) {
  const HeardMisuses heard;
  ApiCrowd crowd(1);
  const Agent agent = crowd.agent(0);
  agent.play({.clip = mannequin().find_clip("walk")});
  const auto feet = agent.add(FootPlacement{});
  ASSERT_TRUE(feet);
  EXPECT_TRUE(agent.processes().set_ground(*feet, -1, {}, {0.0F, 1.0F, 0.0F}));
  EXPECT_FALSE(agent.processes().set_ground(*feet, -1, {}, {0.0F, 2.0F, 0.0F}));
  EXPECT_FALSE(agent.processes().set_ground(*feet, -1, {}, {0.0F, -1.0F, 0.0F})) << "it faces down";
  EXPECT_FALSE(agent.processes().set_ground(*feet, -1, {}, {-3.4e38F, 32767.0F, 1.25F}));
  EXPECT_FALSE(agent.processes().set_ground(*feet, -1, {0.0F, 1e30F, 0.0F}, {0.0F, 1.0F, 0.0F}));
}

TEST(ApiProcesses, OfWhoPlaysNothingAreNowhere) {
  ApiCrowd crowd(1);
  const auto feet = crowd.agent(0).add(FootPlacement{});
  const auto socket = crowd.agent(0).add(Socket{.bone = 3});
  ASSERT_TRUE(feet && socket);
  EXPECT_EQ(crowd.agent(0).processes().ankle(*feet, 0), Vec3{});
  EXPECT_EQ(crowd.agent(0).processes().socket(*socket).position, Vec3{});
}

}  // namespace
}  // namespace throng::processes_test
