// The functions for C do what the classes for C++ do.

#include "throng/c.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/base/aligned_bytes.h"
#include "tests/api/api_crowd.h"

namespace throng::c_test {
namespace {

using api_test::ApiCrowd;
using testing::HasSubstr;

constexpr throng_id first{0, THRONG_NONE};

std::vector<std::string>& heard() {
  static std::vector<std::string> all;
  return all;
}

/// A crowd of the built-in character, made through C.
class CCrowd {
 public:
  explicit CCrowd(std::uint32_t agents) : ids(agents) {
    throng_set_misuse_hook([](const char* call, const char*) { heard().emplace_back(call); });
    heard().clear();
    throng_file* const file = throng_load(THRONG_SOURCE_DIR "/assets/mannequin.glb", 0.0);
    character = throng_file_character(file, 0);
    throng_file_free(file);
    crowd = throng_crowd_create(character, 1, 1);
    throng_crowd_add_agents(crowd, first, agents, ids.data());
  }
  ~CCrowd() {
    throng_crowd_free(crowd);
    throng_character_free(character);
    throng_set_misuse_hook(nullptr);
  }
  CCrowd(const CCrowd&) = delete;
  CCrowd& operator=(const CCrowd&) = delete;

  void step(int frames) {
    std::vector<throng_pose_request> requests;
    for (const throng_id id : ids) requests.push_back({id, 0, nullptr});
    for (int frame = 0; frame < frames; ++frame) {
      throng_crowd_advance(crowd, 1.0 / 60.0);
      throng_crowd_update(crowd, requests.data(), static_cast<std::uint32_t>(requests.size()));
    }
  }

  throng_character* character = nullptr;
  throng_crowd* crowd = nullptr;
  std::vector<throng_id> ids;
};

TEST(ApiC, PosesAsTheOneForCppDoes) {
  CCrowd c(10);
  ApiCrowd cpp(10);
  for (std::uint32_t agent = 0; agent < 10; ++agent) {
    const throng_play play{.clip = agent, .fade = 0.0F, .speed = 1.0F, .start = 0.0F, .loop = 1};
    EXPECT_EQ(throng_agent_play(c.crowd, c.ids[agent], &play), 0);
    cpp.agent(agent).play({.clip = {agent}});
  }
  c.step(20);
  cpp.step(20);
  EXPECT_EQ(throng_crowd_pose_hash(c.crowd), cpp.hash());
}

TEST(ApiC, FindsClipsByTheirRolesToo) {
  CCrowd c(1);
  EXPECT_EQ(throng_character_find_role(c.character, "stand"), throng_character_find_clip(c.character, "idle"));
  EXPECT_EQ(throng_character_find_role(c.character, "Stand"), THRONG_NONE);
  EXPECT_EQ(throng_character_find_role(nullptr, "stand"), THRONG_NONE);
  EXPECT_EQ(heard().size(), 2U);
}

TEST(ApiC, SaysWhyACallFailed) {
  CCrowd c(1);
  EXPECT_EQ(throng_load("no-such-model.glb", 0.0), nullptr);
  EXPECT_THAT(throng_last_error(), HasSubstr("no-such-model.glb"));
  EXPECT_EQ(throng_agent_add_reach(c.crowd, c.ids[0], 9), THRONG_NONE);
  EXPECT_THAT(throng_last_error(), HasSubstr("from 0 to 3"));
  std::vector<float> few(64);
  EXPECT_NE(throng_crowd_update_all(c.crowd, few.data(), 64, 64), 0);
  EXPECT_THAT(throng_last_error(), HasSubstr("no room for the palette of agent 0"));
}

/// Returns why a call failed; "" if it went well.
std::string why(bool has_failed) { return has_failed ? throng_last_error() : ""; }

TEST(ApiC, SaysTheSentenceOfAMisuse) {
  CCrowd c(2);
  constexpr throng_id nobody{7, 7};
  constexpr double never = 1e6;
  const throng_play walk{.clip = 1, .fade = 0.0F, .speed = 1.0F, .start = 0.0F, .loop = 1};
  for (const throng_id id : c.ids) throng_agent_play(c.crowd, id, &walk);
  const std::uint32_t stride = throng_crowd_palette_bytes(c.crowd, first);
  const anim::AlignedBytes memory = anim::allocate_aligned(std::size_t{3} * stride);
  float* const palettes = reinterpret_cast<float*>(memory.get());
  const throng_pose_request of_nobody{nobody, 0, nullptr};
  EXPECT_EQ(why(throng_crowd_update_all(c.crowd, palettes, std::size_t{2} * stride, stride) != 0), "");
  EXPECT_EQ(why(throng_crowd_update_all(c.crowd, palettes + 1, std::size_t{2} * stride, stride) != 0),
            "throng_crowd_update_all: a palette lies at a multiple of 16 bytes");
  EXPECT_EQ(why(throng_crowd_update_all(c.crowd, palettes, std::size_t{3} * stride, stride + 4) != 0),
            "throng_crowd_update_all: a palette lies at a multiple of 16 bytes");
  EXPECT_THAT(why(throng_crowd_update(c.crowd, &of_nobody, 1) != 0), HasSubstr("throng_crowd_update: an agent of"));
  EXPECT_THAT(why(throng_crowd_advance(c.crowd, -1.0) != 0), HasSubstr("throng_crowd_advance: time does not go back"));
  EXPECT_THAT(why(throng_agent_play(c.crowd, nobody, &walk) != 0), HasSubstr("throng_agent_play: an agent of this id"));
  float position[3], rotation[4], turn = 0.0F;
  EXPECT_THAT(why(throng_agent_socket(c.crowd, c.ids[0], 9, position, rotation) != 0),
              HasSubstr("no process of this id"));
  EXPECT_THAT(why(throng_agent_displacement(c.crowd, c.ids[0], 0.0, never, position, &turn) != 0),
              HasSubstr("within a day of the clock"));
  EXPECT_THAT(why(throng_agent_keys(c.crowd, c.ids[0], 0.0, never, nullptr, 0) == 0),
              HasSubstr("throng_agent_keys: times are within a day of the clock"));
  EXPECT_THAT(why(throng_agent_is_playing(c.crowd, c.ids[0], 9) == 0), HasSubstr("the agent has no slot of this id"));
  EXPECT_THAT(why(throng_agent_state(c.crowd, c.ids[0], 9) == THRONG_NONE), HasSubstr("throng_agent_state: "));
}

TEST(ApiC, RefusesNull) {
  CCrowd c(1);
  const throng_id nobody{7, 7};
  EXPECT_EQ(throng_load(nullptr, 0.0), nullptr);
  EXPECT_EQ(throng_crowd_create(nullptr, 1, 0), nullptr);
  EXPECT_NE(throng_agent_play(nullptr, nobody, nullptr), 0);
  EXPECT_NE(throng_agent_play(c.crowd, nobody, nullptr), 0);
  EXPECT_EQ(throng_crowd_agent_count(nullptr), 0U);
  throng_crowd_advance(nullptr, 1.0);
  EXPECT_EQ(heard().size(), 6U);
  throng_file_free(nullptr);
  throng_crowd_free(nullptr);
}

TEST(ApiC, ReachesAndTellsWhereTheHandIs) {
  CCrowd c(1);
  const throng_play idle{
      .clip = throng_character_find_clip(c.character, "idle"), .fade = 0, .speed = 1, .start = 0, .loop = 1};
  throng_agent_play(c.crowd, c.ids[0], &idle);
  const auto hand = static_cast<std::uint32_t>(*api_test::mannequin().find_bone("hand.R"));
  EXPECT_STREQ(throng_character_bone_name(c.character, hand), "hand.R");
  const std::uint32_t reach = throng_agent_add_reach(c.crowd, c.ids[0], 1);
  const std::uint32_t socket = throng_agent_add_socket(c.crowd, c.ids[0], hand);
  const float target[3] = {-0.3F, 1.2F, 0.3F};
  EXPECT_EQ(throng_agent_reach(c.crowd, c.ids[0], reach, target, 1.0F, 0.0F), 0);
  c.step(3);
  float position[3], rotation[4];
  EXPECT_EQ(throng_agent_socket(c.crowd, c.ids[0], socket, position, rotation), 0);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(position[axis], target[axis], 0.01F);
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
  const std::uint32_t body = throng_agent_add_machine(c.crowd, c.ids[0], machine);
  const std::uint32_t slot = throng_agent_add_slot(c.crowd, c.ids[0]);
  const throng_one_shot wave{.clip = throng_character_find_clip(c.character, "wave"),
                             .fade_in = 0.1F,
                             .fade_out = 0.1F,
                             .speed = 1,
                             .queued = 0};
  EXPECT_EQ(throng_agent_play_once(c.crowd, c.ids[0], slot, &wave), 0);
  EXPECT_EQ(throng_agent_is_playing(c.crowd, c.ids[0], slot), 1);
  EXPECT_EQ(throng_agent_set_input(c.crowd, c.ids[0], body, throng_machine_find_input(machine, "seated"), 1.0F), 0);
  c.step(10);
  EXPECT_STREQ(throng_machine_state_name(machine, throng_agent_state(c.crowd, c.ids[0], body)), "sits");
  EXPECT_NE(throng_agent_set_input(c.crowd, c.ids[0], slot, 0, 1.0F), 0) << "a slot is no machine";
  EXPECT_EQ(throng_machine_find_input(machine, "asleep"), THRONG_NONE);
  EXPECT_EQ(throng_machine_state_name(machine, 7), nullptr);
  throng_machine_free(machine);  // the agent plays on
  c.step(10);
}

TEST(ApiC, MovesMeetsKeysAndIsPutBack) {
  CCrowd c(1);
  const throng_play walk{
      .clip = throng_character_find_clip(c.character, "walk"), .fade = 0, .speed = 1, .start = 0, .loop = 1};
  throng_agent_play(c.crowd, c.ids[0], &walk);
  throng_snapshot* const start = throng_crowd_snapshot(c.crowd);
  c.step(120);
  throng_key keys[16];
  float way[3], turn = 1.0F;
  EXPECT_GT(throng_agent_keys(c.crowd, c.ids[0], 0.0, 2.0, keys, 16), 1U);
  EXPECT_STRNE(throng_character_key_name(c.character, keys[0].name), "");
  EXPECT_EQ(throng_agent_displacement(c.crowd, c.ids[0], 0.0, 2.0, way, &turn), 0);
  EXPECT_GT(way[2], 1.0F);
  const std::uint64_t hash = throng_crowd_pose_hash(c.crowd);
  EXPECT_EQ(throng_crowd_restore(c.crowd, start), 0);
  EXPECT_EQ(throng_crowd_clock(c.crowd), 0.0);
  c.step(120);
  EXPECT_EQ(throng_crowd_pose_hash(c.crowd), hash);
  throng_snapshot_free(start);
}

TEST(ApiC, TakesRequestsToManyAgentsInOneCall) {
  CCrowd many(3), alone(3);
  const std::uint32_t clips[] = {throng_character_find_clip(many.character, "idle"),
                                 throng_character_find_clip(many.character, "walk")};
  const float speeds[] = {0.0F, 1.35F};
  std::vector<throng_parameter_request> walks;
  std::vector<throng_gaze_request> gazes;
  for (CCrowd* crowd : {&many, &alone}) {
    for (const throng_id agent : crowd->ids) {
      const std::uint32_t channel = throng_agent_add_blend_space(crowd->crowd, agent, clips, speeds, 2, 1);
      const std::uint32_t gaze = throng_agent_add_look_at(crowd->crowd, agent);
      if (crowd == &many) {
        walks.push_back({.agent = agent, .channel = channel, .x = 1.0F, .y = 0.0F});
        gazes.push_back({.agent = agent, .process = gaze, .target = {1.0F, 1.5F, 2.0F}, .fade = 0.2F});
      } else {
        const float target[] = {1.0F, 1.5F, 2.0F};
        EXPECT_EQ(throng_agent_set_parameter(crowd->crowd, agent, channel, 1.0F), 0);
        EXPECT_EQ(throng_agent_look_at(crowd->crowd, agent, gaze, target, 0.2F), 0);
      }
    }
  }
  EXPECT_EQ(throng_crowd_set_parameters(many.crowd, walks.data(), 3), 0);
  EXPECT_EQ(throng_crowd_look_at(many.crowd, gazes.data(), 3), 0);
  for (CCrowd* crowd : {&many, &alone}) crowd->step(60);
  EXPECT_EQ(throng_crowd_pose_hash(many.crowd), throng_crowd_pose_hash(alone.crowd));
  throng_root_motion ways[3];
  ASSERT_EQ(throng_crowd_displacements(many.crowd, 0.0, 1.0, many.ids.data(), 3, ways), 0);
  for (const throng_root_motion& way : ways) EXPECT_NEAR(way.displacement[2], 1.0F, 0.02F);
  const throng_speed_request speed{.agent = many.ids[0], .speed = 2.0F};
  EXPECT_NE(throng_crowd_set_speeds(many.crowd, &speed, 1), 0) << "its first channel plays no clip";
  EXPECT_STRNE(throng_last_error(), "");
}

}  // namespace
}  // namespace throng::c_test
