// Requests to many agents through the functions for C.

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/api/c/c_crowd.h"

namespace throng::c_many_test {
namespace {

using api_test::CCrowd;

/// Three agents with gaits, a gaze, an arm that reaches, feet and a socket.
struct CWalkers : CCrowd {
  std::vector<std::uint32_t> gaits, gazes, arms, feet, sockets;

  CWalkers() : CCrowd(3) {
    const throng_blend_point points[] = {{.clip = clip("idle"), .parameter = 0.0F, .pace = THRONG_PACE_AUTOMATIC},
                                         {.clip = clip("walk"), .parameter = 1.35F, .pace = THRONG_PACE_AUTOMATIC}};
    throng_blend_space space = throng_blend_space_default();
    space.points = points;
    space.point_count = 2;
    for (const throng_id agent : ids) {
      gaits.push_back(throng_agent_add_blend_space(crowd, agent, &space, nullptr));
      gazes.push_back(throng_agent_add_look_at(crowd, agent, nullptr));
      arms.push_back(throng_agent_add_reach(crowd, agent, nullptr));
      feet.push_back(throng_agent_add_foot_placement(crowd, agent, nullptr));
      sockets.push_back(throng_agent_add_socket(crowd, agent, nullptr));
      throng_agent_set_process_weight(crowd, agent, arms.back(), 1.0F, 0.0F);
    }
  }
};

constexpr float aside[] = {1.0F, 1.5F, 2.0F}, ahead[] = {-0.3F, 1.2F, 0.4F};
constexpr float step_up[] = {0.0F, 0.1F, 0.0F}, up[] = {0.0F, 1.0F, 0.0F};
constexpr throng_place away{.position = {3.0F, 0.0F, 0.0F}, .rotation = {0.0F, 0.0F, 0.0F, 1.0F}};

void ask_each(const CWalkers& one) {
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_EQ(throng_agent_set_parameter(one.crowd, one.ids[i], one.gaits[i], 1.0F), 0);
    EXPECT_EQ(throng_agent_look_at(one.crowd, one.ids[i], one.gazes[i], aside, 0.2F), 0);
    EXPECT_EQ(throng_agent_reach(one.crowd, one.ids[i], one.arms[i], ahead, 1.0F, 0.0F), 0);
    EXPECT_EQ(throng_agent_set_placement(one.crowd, one.ids[i], one.feet[i], &away), 0);
    EXPECT_EQ(throng_agent_set_ground(one.crowd, one.ids[i], one.feet[i], THRONG_NONE, step_up, up), 0);
  }
}

void ask_all(const CWalkers& all) {
  std::vector<throng_parameter_request> walks;
  std::vector<throng_gaze_request> gazes;
  std::vector<throng_reach_request> reaches;
  std::vector<throng_placement_request> places;
  std::vector<throng_ground_request> grounds;
  for (std::uint32_t i = 0; i < 3; ++i) {
    walks.push_back({.agent = all.ids[i], .channel = all.gaits[i], .x = 1.0F, .y = 0.0F});
    gazes.push_back({.agent = all.ids[i], .process = all.gazes[i], .target = {1.0F, 1.5F, 2.0F}, .fade = 0.2F});
    reaches.push_back({.agent = all.ids[i], .process = all.arms[i], .target = {-0.3F, 1.2F, 0.4F}});
    places.push_back({.agent = all.ids[i], .process = all.feet[i], .model_in_world = away});
    grounds.push_back({.agent = all.ids[i],
                       .process = all.feet[i],
                       .leg = THRONG_NONE,
                       .point = {0.0F, 0.1F, 0.0F},
                       .normal = {0.0F, 1.0F, 0.0F}});
  }
  EXPECT_EQ(throng_crowd_set_parameters(all.crowd, walks.data(), 3), 0);
  EXPECT_EQ(throng_crowd_look_at(all.crowd, gazes.data(), 3), 0);
  EXPECT_EQ(throng_crowd_reach(all.crowd, reaches.data(), 3), 0);
  EXPECT_EQ(throng_crowd_set_placements(all.crowd, places.data(), 3), 0);
  EXPECT_EQ(throng_crowd_set_grounds(all.crowd, grounds.data(), 3), 0);
}

TEST(ApiCMany, ArePosedAsIfEachWereAskedAlone) {
  const CWalkers many, alone;
  ask_all(many);
  ask_each(alone);
  many.step(60);
  alone.step(60);
  EXPECT_EQ(many.hash(), alone.hash());
  EXPECT_TRUE(many.heard.empty());
}

TEST(ApiCMany, TellHowTheyMoveAsEachDoesAlone) {
  const CWalkers walkers;
  ask_all(walkers);
  walkers.step(120);
  throng_root_motion ways[3], way;
  throng_place places[3], place;
  std::vector<throng_process_of> sockets;
  for (std::uint32_t i = 0; i < 3; ++i) sockets.push_back({.agent = walkers.ids[i], .process = walkers.sockets[i]});
  ASSERT_EQ(throng_crowd_displacements(walkers.crowd, 0.0, 2.0, walkers.ids.data(), 3, ways), 0);
  ASSERT_EQ(throng_crowd_sockets(walkers.crowd, sockets.data(), 3, places), 0);
  throng_agent_displacement(walkers.crowd, walkers.ids[2], 0.0, 2.0, &way);
  throng_agent_socket(walkers.crowd, walkers.ids[2], walkers.sockets[2], &place);
  EXPECT_NEAR(ways[2].displacement[2], 2.0F, 0.04F);
  EXPECT_EQ(ways[2].displacement[2], way.displacement[2]);
  EXPECT_EQ(places[2].position[1], place.position[1]);

  throng_key alone[16];
  const std::uint32_t met = throng_agent_keys(walkers.crowd, walkers.ids[1], 0.0, 2.0, THRONG_KEYS_ALL, alone, 16);
  throng_agent_key keys[64];
  const std::uint32_t all =
      throng_crowd_keys(walkers.crowd, 0.0, 2.0, walkers.ids.data(), 3, THRONG_KEYS_ALL, keys, 64);
  ASSERT_GT(met, 1U);
  ASSERT_EQ(all, 3 * met);
  EXPECT_EQ(keys[met].agent.number, walkers.ids[1].number);
  EXPECT_EQ(keys[met].key.time, alone[0].time);
  EXPECT_EQ(throng_crowd_keys(walkers.crowd, 0.0, 2.0, walkers.ids.data(), 3, THRONG_KEYS_ALL, keys, 1), all)
      << "it says how many there are";
}

TEST(ApiCMany, TakeAnEmptyArrayThatIsNull) {
  const CWalkers walkers;
  EXPECT_EQ(throng_crowd_set_speeds(walkers.crowd, nullptr, 0), 0);
  EXPECT_EQ(throng_crowd_displacements(walkers.crowd, 0.0, 0.0, nullptr, 0, nullptr), 0);
  EXPECT_EQ(throng_crowd_add_agents(walkers.crowd, api_test::first_character, 0, nullptr), 0);
  EXPECT_TRUE(walkers.heard.empty());
  EXPECT_NE(throng_crowd_set_speeds(walkers.crowd, nullptr, 1), 0);
}

TEST(ApiCMany, FailWhereATimeIsNoNumber) {
  const CWalkers walkers;
  throng_play play = throng_play_default();
  play.clip = walkers.clip("walk");
  play.fade = NAN;
  EXPECT_NE(throng_agent_play(walkers.crowd, walkers.ids[0], &play), 0);
  EXPECT_NE(throng_crowd_advance(walkers.crowd, NAN), 0);
  EXPECT_EQ(throng_crowd_clock(walkers.crowd), 0.0);
  throng_root_motion way;
  EXPECT_NE(throng_crowd_displacements(walkers.crowd, NAN, 0.0, walkers.ids.data(), 1, &way), 0);
  EXPECT_EQ(throng_crowd_keys(walkers.crowd, NAN, 1.0, walkers.ids.data(), 1, THRONG_KEYS_ALL, nullptr, 0), 0U);
  EXPECT_STRNE(throng_last_error(), "");
}

TEST(ApiCMany, TellOfTheTimeAndTheKeysThatAreAskedFor) {
  const CWalkers walkers;
  ask_all(walkers);
  walkers.step(120);
  throng_root_motion ways[3], way;
  ASSERT_EQ(throng_crowd_displacements(walkers.crowd, 1.5, 2.0, walkers.ids.data(), 3, ways), 0);
  throng_agent_displacement(walkers.crowd, walkers.ids[0], 1.5, 2.0, &way);
  EXPECT_EQ(ways[0].displacement[2], way.displacement[2]);
  const throng_parameter_request slow{.agent = walkers.ids[0], .channel = walkers.gaits[0], .x = 0.3F, .y = 0.0F};
  EXPECT_EQ(throng_crowd_set_parameters(walkers.crowd, &slow, 1), 0);
  walkers.step(240);
  const auto count = [&](std::uint32_t choice) {
    return throng_crowd_keys(walkers.crowd, 4.0, 6.0, walkers.ids.data(), 1, choice, nullptr, 0);
  };
  EXPECT_GT(count(THRONG_KEYS_FELT), 0U);
  EXPECT_EQ(count(THRONG_KEYS_HEAVIEST), 0U) << "it stands more than it walks";
}

TEST(ApiCMany, FailWhereOneRequestCannotBeMet) {
  const CWalkers walkers;
  const throng_speed_request speed{.agent = walkers.ids[0], .speed = 2.0F};
  EXPECT_NE(throng_crowd_set_speeds(walkers.crowd, &speed, 1), 0) << "its first channel plays no clip";
  EXPECT_STRNE(throng_last_error(), "");
}

}  // namespace
}  // namespace throng::c_many_test
