// The functions for C do what the classes for C++ do.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/base/aligned_bytes.h"
#include "tests/api/c/c_crowd.h"

namespace throng::c_test {
namespace {

using api_test::ApiCrowd;
using api_test::CCrowd;
using api_test::first_character;
using api_test::why;
using testing::HasSubstr;

TEST(ApiC, PosesAsTheOneForCppDoes) {
  CCrowd c(10);
  ApiCrowd cpp(10);
  for (std::uint32_t agent = 0; agent < 10; ++agent) {
    EXPECT_EQ(c.play(agent, agent), 0);
    cpp.agent(agent).play({.clip = {agent}});
  }
  c.step(20);
  cpp.step(20);
  EXPECT_EQ(c.hash(), cpp.hash());
}

TEST(ApiC, FindsClipsByTheirRolesToo) {
  CCrowd c(1);
  EXPECT_EQ(throng_character_find_role(c.character, "stand"), throng_character_find_clip(c.character, "idle"));
  EXPECT_EQ(throng_character_find_role(c.character, "Stand"), THRONG_NONE);
  EXPECT_EQ(throng_character_find_role(nullptr, "stand"), THRONG_NONE);
  EXPECT_EQ(c.heard.size(), 2U);
}

TEST(ApiC, SaysWhyACallFailed) {
  CCrowd c(1);
  EXPECT_EQ(throng_load("no-such-model.glb", 0.0), nullptr);
  EXPECT_THAT(throng_last_error(), HasSubstr("no-such-model.glb"));
  throng_reach tail = throng_reach_default();
  tail.limb = 9;
  EXPECT_EQ(throng_agent_add_reach(c.crowd, c.ids[0], &tail), THRONG_NONE);
  EXPECT_STREQ(throng_last_error(), "throng_agent_add_reach: throng_reach::limb is none of its constants");
  std::vector<float> few(64);
  EXPECT_NE(throng_crowd_update_all(c.crowd, few.data(), 64, 64), 0);
  EXPECT_THAT(throng_last_error(), HasSubstr("no room for the palette of agent 0"));
}

TEST(ApiC, SaysTheSentenceOfAMisuse) {
  CCrowd c(2);
  constexpr throng_id nobody{7, 7};
  constexpr double never = 1e6;
  throng_play walk = throng_play_default();
  walk.clip = 1;
  for (const throng_id id : c.ids) throng_agent_play(c.crowd, id, &walk);
  const std::uint32_t stride = throng_crowd_palette_bytes(c.crowd, first_character);
  const anim::AlignedBytes memory = anim::allocate_aligned(std::size_t{3} * stride);
  float* const palettes = reinterpret_cast<float*>(memory.get());
  throng_pose_request of_nobody{};
  of_nobody.agent = nobody;
  EXPECT_EQ(why(throng_crowd_update_all(c.crowd, palettes, std::size_t{2} * stride, stride) != 0), "");
  EXPECT_EQ(why(throng_crowd_update_all(c.crowd, palettes + 1, std::size_t{2} * stride, stride) != 0),
            "throng_crowd_update_all: a palette lies at a multiple of 16 bytes");
  EXPECT_EQ(why(throng_crowd_update_all(c.crowd, palettes, std::size_t{3} * stride, stride + 4) != 0),
            "throng_crowd_update_all: a palette lies at a multiple of 16 bytes");
  EXPECT_THAT(why(throng_crowd_update(c.crowd, &of_nobody, 1) != 0), HasSubstr("throng_crowd_update: an agent of"));
  EXPECT_THAT(why(throng_crowd_advance(c.crowd, -1.0) != 0), HasSubstr("throng_crowd_advance: time does not go back"));
  EXPECT_THAT(why(throng_agent_play(c.crowd, nobody, &walk) != 0), HasSubstr("throng_agent_play: an agent of this id"));
  throng_place place;
  throng_root_motion way;
  EXPECT_THAT(why(throng_agent_socket(c.crowd, c.ids[0], 9, &place) != 0), HasSubstr("no process of this id"));
  EXPECT_THAT(why(throng_agent_displacement(c.crowd, c.ids[0], 0.0, never, &way) != 0),
              HasSubstr("within a day of the clock"));
  EXPECT_THAT(why(throng_agent_keys(c.crowd, c.ids[0], 0.0, never, THRONG_KEYS_FELT, nullptr, 0) == 0),
              HasSubstr("throng_agent_keys: times are within a day of the clock"));
  EXPECT_THAT(why(throng_agent_is_playing(c.crowd, c.ids[0], 9) == 0), HasSubstr("the agent has no slot of this id"));
  EXPECT_THAT(why(throng_agent_state(c.crowd, c.ids[0], 9) == THRONG_NONE), HasSubstr("throng_agent_state: "));
}

TEST(ApiC, RefusesNull) {
  CCrowd c(1);
  const throng_id nobody{7, 7};
  EXPECT_EQ(throng_load(nullptr, 0.0), nullptr);
  EXPECT_EQ(throng_crowd_create(nullptr, nullptr), nullptr);
  EXPECT_NE(throng_agent_play(nullptr, nobody, nullptr), 0);
  EXPECT_NE(throng_agent_play(c.crowd, nobody, nullptr), 0);
  EXPECT_EQ(throng_crowd_agent_count(nullptr), 0U);
  throng_crowd_advance(nullptr, 1.0);
  EXPECT_EQ(c.heard.size(), 6U);
  throng_file_free(nullptr);
  throng_crowd_free(nullptr);
}

TEST(ApiC, ReachesAndTellsWhereTheHandIs) {
  CCrowd c(1);
  c.play(0, c.clip("idle"));
  const std::uint32_t hand = c.bone("hand.R");
  EXPECT_STREQ(throng_character_bone_name(c.character, hand), "hand.R");
  const std::uint32_t reach = throng_agent_add_reach(c.crowd, c.ids[0], nullptr);
  throng_socket in_hand = throng_socket_default();
  in_hand.bone = hand;
  const std::uint32_t socket = throng_agent_add_socket(c.crowd, c.ids[0], &in_hand);
  const float target[3] = {-0.3F, 1.2F, 0.3F};
  EXPECT_EQ(throng_agent_reach(c.crowd, c.ids[0], reach, target, 1.0F, 0.0F), 0);
  c.step(3);
  throng_place held;
  EXPECT_EQ(throng_agent_socket(c.crowd, c.ids[0], socket, &held), 0);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(held.position[axis], target[axis], 0.01F);
}

TEST(ApiC, PlaysAStateMachineUnderASlot) {
  CCrowd c(1);
  EXPECT_EQ(throng_machine_parse("{}", c.character), nullptr);
  EXPECT_THAT(throng_last_error(), HasSubstr("has states"));
  EXPECT_EQ(throng_machine_load("no-such-file.json", c.character), nullptr);
  throng_machine* const machine = throng_machine_parse(
      R"({"inputs": [{"name": "seated", "value": false}],
          "states": [{"name": "stands", "clip": "idle"}, {"name": "sits", "clip": "sit"}],
          "transitions": [{"from": "stands", "to": "sits", "when": ["seated"], "fade": 0.1},
                          {"from": "sits", "to": "stands", "when": ["not seated"], "fade": 0.1}]})",
      c.character);
  ASSERT_NE(machine, nullptr) << throng_last_error();
  const std::uint32_t body = throng_agent_add_machine(c.crowd, c.ids[0], machine, nullptr);
  const std::uint32_t slot = throng_agent_add_slot(c.crowd, c.ids[0], nullptr);
  throng_one_shot wave = throng_one_shot_default();
  wave.clip = c.clip("wave");
  wave.fade_in = wave.fade_out = 0.1F;
  EXPECT_EQ(throng_agent_play_once(c.crowd, c.ids[0], slot, &wave), 0);
  EXPECT_EQ(throng_agent_is_playing(c.crowd, c.ids[0], slot), 1);
  EXPECT_EQ(throng_agent_set_input(c.crowd, c.ids[0], body, throng_machine_find_input(machine, "seated"), 1.0F), 0);
  c.step(10);
  EXPECT_STREQ(throng_machine_state_name(machine, throng_agent_state(c.crowd, c.ids[0], body)), "sits");
  EXPECT_EQ(throng_machine_find_state(machine, "sits"), throng_agent_state(c.crowd, c.ids[0], body));
  EXPECT_EQ(throng_agent_state_entered_at(c.crowd, c.ids[0], body), 0.0);
  EXPECT_NE(throng_agent_set_input(c.crowd, c.ids[0], slot, 0, 1.0F), 0) << "a slot is no machine";
  EXPECT_EQ(throng_machine_find_input(machine, "asleep"), THRONG_NONE);
  EXPECT_EQ(throng_machine_state_name(machine, 7), nullptr);
  throng_machine_free(machine);  // the agent plays on
  c.step(10);
}

TEST(ApiC, MovesMeetsKeysAndIsPutBack) {
  CCrowd c(1);
  c.play(0, c.clip("walk"));
  throng_snapshot* const start = throng_crowd_snapshot(c.crowd);
  c.step(120);
  throng_key keys[16];
  throng_root_motion way;
  EXPECT_GT(throng_agent_keys(c.crowd, c.ids[0], 0.0, 2.0, THRONG_KEYS_ALL, keys, 16), 1U);
  EXPECT_STRNE(throng_character_key_name(c.character, keys[0].name), "");
  EXPECT_EQ(throng_agent_displacement(c.crowd, c.ids[0], 0.0, 2.0, &way), 0);
  EXPECT_GT(way.displacement[2], 1.0F);
  const std::uint64_t hash = c.hash();
  EXPECT_EQ(throng_crowd_restore(c.crowd, start), 0);
  EXPECT_EQ(throng_crowd_clock(c.crowd), 0.0);
  c.step(120);
  EXPECT_EQ(c.hash(), hash);
  EXPECT_EQ(throng_crowd_snapshot_into(c.crowd, start), 0);
  EXPECT_EQ(throng_crowd_restore(c.crowd, start), 0);
  EXPECT_EQ(throng_crowd_clock(c.crowd), 2.0) << "the snapshot was taken again";
  EXPECT_GT(throng_snapshot_bytes(start), 0U);
  throng_snapshot_free(start);
}

}  // namespace
}  // namespace throng::c_test
