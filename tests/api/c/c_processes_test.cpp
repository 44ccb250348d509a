// Processes and steps of the host's own through the functions for C.

#include <cmath>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/api/c/c_crowd.h"

namespace throng::c_processes_test {
namespace {

using api_test::ApiCrowd;
using api_test::CCrowd;
using api_test::first_character;
using api_test::mannequin;
using testing::HasSubstr;

void set_up(const CCrowd& c) {
  throng_spring_chain chain = throng_spring_chain_default();
  chain.first = "upper_arm.L";
  chain.last = "hand.L";
  throng_spring_collider collider = throng_spring_collider_default();
  collider.bone = "chest";
  throng_springs springs = throng_springs_default();
  springs.chains = &chain;
  springs.chain_count = 1;
  springs.colliders = &collider;
  springs.collider_count = 1;
  throng_chain_reach reach = throng_chain_reach_default();
  reach.first = "spine";
  reach.last = "head";
  throng_noise noise = throng_noise_default();
  noise.seed = 7;
  EXPECT_EQ(throng_agent_add_noise(c.crowd, c.ids[0], &noise), 0U) << throng_last_error();
  EXPECT_EQ(throng_agent_add_springs(c.crowd, c.ids[0], &springs), 1U) << throng_last_error();
  EXPECT_EQ(throng_agent_add_chain_reach(c.crowd, c.ids[0], &reach), 2U) << throng_last_error();
  EXPECT_EQ(throng_agent_add_foot_placement(c.crowd, c.ids[0], nullptr), 3U) << throng_last_error();
  EXPECT_EQ(throng_agent_add_look_at(c.crowd, c.ids[0], nullptr), 4U) << throng_last_error();
}

void set_up(const Agent& agent) {
  const SpringChain chain{.first = "upper_arm.L", .last = "hand.L"};
  const SpringCollider collider{.bone = "chest"};
  EXPECT_TRUE(agent.add(Noise{.seed = 7}));
  EXPECT_TRUE(agent.add(Springs{.chains = {&chain, 1}, .colliders = {&collider, 1}}));
  EXPECT_TRUE(agent.add(ChainReach{.first = "spine", .last = "head"}));
  EXPECT_TRUE(agent.add(FootPlacement{}));
  EXPECT_TRUE(agent.add(LookAt{}));
}

TEST(ApiCProcesses, OfAnyKindPoseAsThoseOfCppDo) {
  const CCrowd c(1);
  ApiCrowd cpp(1);
  c.play(0, c.clip("walk"));
  cpp.agent(0).play({.clip = mannequin().find_clip("walk")});
  set_up(c);
  set_up(cpp.agent(0));
  const float target[] = {0.2F, 1.6F, 0.2F}, slope[] = {0.0F, 0.05F, 0.0F}, up[] = {0.0F, 1.0F, 0.0F};
  const throng_place place{.position = {1.0F, 0.0F, 0.0F}, .rotation = {0.0F, 0.0F, 0.0F, 1.0F}};
  const Processes own = cpp.agent(0).processes();
  for (int frame = 0; frame < 30; ++frame) {
    EXPECT_EQ(throng_agent_reach(c.crowd, c.ids[0], 2, target, 0.5F, 0.1F), 0);
    EXPECT_EQ(throng_agent_set_placement(c.crowd, c.ids[0], 1, &place), 0);
    EXPECT_EQ(throng_agent_set_placement(c.crowd, c.ids[0], 3, &place), 0);
    EXPECT_EQ(throng_agent_set_ground(c.crowd, c.ids[0], 3, THRONG_NONE, slope, up), 0);
    EXPECT_EQ(throng_agent_look_at(c.crowd, c.ids[0], 4, target, 0.1F), 0);
    own.reach({2}, {0.2F, 1.6F, 0.2F});
    own.set_weight({2}, 0.5F, ticks_per_second / 10);
    for (const ProcessId process : {ProcessId{1}, ProcessId{3}}) own.set_placement(process, {.position = {1.0F}});
    own.set_ground({3}, -1, {0.0F, 0.05F, 0.0F}, {0.0F, 1.0F, 0.0F});
    own.look_at({4}, {0.2F, 1.6F, 0.2F}, ticks_per_second / 10);
    c.step();
    cpp.step();
  }
  EXPECT_EQ(c.hash(), cpp.hash());
  float ankle[3];
  EXPECT_EQ(throng_agent_ankle(c.crowd, c.ids[0], 3, 0, ankle), 0);
  EXPECT_EQ(ankle[1], own.ankle({3}, 0).y);
  EXPECT_EQ(throng_agent_look_away(c.crowd, c.ids[0], 4, 0.1F), 0);
  EXPECT_EQ(throng_agent_remove_process(c.crowd, c.ids[0], 4), 0);
  EXPECT_NE(throng_agent_look_away(c.crowd, c.ids[0], 4, 0.1F), 0) << "it is gone";
  EXPECT_FALSE(c.heard.empty());
}

TEST(ApiCProcesses, ARagdollFallsAndStandsUpAgain) {
  const CCrowd c(1);
  c.play(0, c.clip("idle"));
  const std::uint32_t ragdoll = throng_agent_add_ragdoll(c.crowd, c.ids[0], nullptr);
  c.step();
  const float impulse[] = {0.0F, 0.0F, 120.0F}, chest[] = {0.0F, 1.3F, 0.0F};
  EXPECT_EQ(throng_agent_is_down(c.crowd, c.ids[0], ragdoll), 0);
  EXPECT_EQ(throng_agent_push(c.crowd, c.ids[0], ragdoll, impulse, chest), 0);
  c.step(60);
  EXPECT_EQ(throng_agent_is_down(c.crowd, c.ids[0], ragdoll), 1);
  EXPECT_EQ(throng_agent_recover(c.crowd, c.ids[0], ragdoll, 0.2F), 0);
  c.step(60);
  EXPECT_EQ(throng_agent_is_down(c.crowd, c.ids[0], ragdoll), 0);
}

TEST(ApiCProcesses, WithoutTheBonesThatTheyNameAreRefused) {
  const CCrowd c(1);
  EXPECT_EQ(throng_agent_add_chain_reach(c.crowd, c.ids[0], nullptr), THRONG_NONE);
  EXPECT_THAT(throng_last_error(), HasSubstr("no bone named"));
  throng_springs springs = throng_springs_default();
  springs.chain_count = 3;
  EXPECT_EQ(throng_agent_add_springs(c.crowd, c.ids[0], &springs), THRONG_NONE);
  EXPECT_THAT(throng_last_error(), HasSubstr("a pointer is null"));
}

/// Turns the root by half a radian a second, and remembers the seconds.
void turn(const throng_step_job* job) {
  auto* const seconds = static_cast<double*>(job->memory);
  *seconds += job->delta;
  const float half = *static_cast<const float*>(job->user) * 0.5F * static_cast<float>(*seconds);
  const float turned[] = {0.0F, std::sin(half), 0.0F, std::cos(half)};
  throng_step_set_rotation(job, 0, turned);
  float place[3];
  throng_step_position(job, 0, place);
  place[0] += 1.0F;
  throng_step_set_position(job, 0, place);
  throng_step_set_rotation(job, 5000, turned);  // a bone that there is not
  float read[4];
  throng_step_rotation(job, throng_step_bone_count(job) - 1, read);
}

TEST(ApiCSteps, OfTheHostsOwnChangeThePoseAndRemember) {
  const CCrowd c(2);
  for (std::uint32_t agent = 0; agent < 2; ++agent) c.play(agent, c.clip("idle"));
  float speed = 0.5F;
  throng_step step = throng_step_default();
  step.name = "turn";
  step.memory_bytes = sizeof(double);
  step.run = turn;
  step.user = &speed;
  const std::uint32_t kind = throng_crowd_add_step(c.crowd, first_character, &step);
  ASSERT_NE(kind, THRONG_NONE) << throng_last_error();
  ASSERT_NE(throng_agent_add_step(c.crowd, c.ids[1], kind), THRONG_NONE) << throng_last_error();
  const std::uint32_t sockets[] = {throng_agent_add_socket(c.crowd, c.ids[0], nullptr),
                                   throng_agent_add_socket(c.crowd, c.ids[1], nullptr)};
  c.step(120);
  throng_place still, turned;
  throng_agent_socket(c.crowd, c.ids[0], sockets[0], &still);
  throng_agent_socket(c.crowd, c.ids[1], sockets[1], &turned);
  EXPECT_NEAR(2.0F * std::atan2(std::abs(turned.rotation[1]), turned.rotation[3]), 1.0F, 0.05F)
      << "half a radian a second for two";
  EXPECT_NEAR(turned.position[0], still.position[0] + 1.0F, 0.05F);
  EXPECT_EQ(throng_agent_add_step(c.crowd, c.ids[1], 5), THRONG_NONE);
  step.run = nullptr;
  EXPECT_EQ(throng_crowd_add_step(c.crowd, first_character, &step), THRONG_NONE);
  EXPECT_THAT(throng_last_error(), HasSubstr("a step needs a function"));
}

}  // namespace
}  // namespace throng::c_processes_test
