// An agent of a system: a small value that reads one agent, and takes requests for it alone.

#include <array>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/agent/noise_process.h"
#include "engine/anim/agent/simple_channel.h"
#include "tests/anim/agent/crowd_rig.h"
#include "tests/anim/agent/heard_misuses.h"

namespace throng::anim::agent_test {
namespace {

constexpr std::uint32_t two = 2;

CrowdRig two_agents() {
  CrowdRig crowd({}, two);
  for (std::uint32_t agent = 0; agent < two; ++agent) crowd->agent(agent).play({.clip = 0});
  return crowd;
}

/// Returns where an agent is in the clip that it plays alone.
FineTicks position_of(const CrowdRig& crowd, std::uint32_t agent) {
  const AgentView view = std::as_const(*crowd).agent(agent);
  return view.pools().as<Player>(view.graph().root()).position;
}

TEST(Agent, IsCopiedAsIs) {
  static_assert(std::is_trivially_copyable_v<Agent> && sizeof(Agent) <= 32);
  const CrowdRig crowd = two_agents();
  const Agent second = crowd->agent(1);
  EXPECT_EQ(second.number(), 1U);
  EXPECT_EQ(second.character_number(), 0U);
  EXPECT_EQ(&second.character(), &crowd->characters()[0]);
}

TEST(Agent, OfAConstSystemCanOnlyBeRead) {
  const CrowdRig crowd = two_agents();
  const AnimationSystem& looked_at = *crowd;
  static_assert(std::is_same_v<decltype(looked_at.agent(0)), AgentView>);
  EXPECT_EQ(looked_at.agent(1).channel_count(), 1U);
  EXPECT_EQ(&looked_at.agent(1).graph(), &crowd->agent(1).graph());
}

TEST(Agent, TakesRequestsForItselfAlone) {
  CrowdRig crowd = two_agents();
  CrowdRig other = two_agents();
  crowd->agent(1).play({.clip = 1});
  for (CrowdRig* each : {&crowd, &other}) each->step(5);
  EXPECT_TRUE(crowd.bones_unlike(other, 0).empty());
  EXPECT_FALSE(crowd.bones_unlike(other, 1).empty());
}

TEST(Agent, ChangesTheSpeedOfWhatItPlays) {
  CrowdRig crowd = two_agents();
  crowd->agent(1).set_speed(0.0);
  crowd.step(2);
  EXPECT_EQ(position_of(crowd, 1), 0);
  EXPECT_EQ(position_of(crowd, 0), 2 * frame_ticks * fine_ticks_per_tick);
}

/// Fades, layers and cuts, so that the clip asked for last is at every place of a graph.
void ask_for_much(CrowdRig& crowd) {
  crowd->agent(0).play({.clip = 1, .fade = ticks_per_second / 2});
  crowd->agent(1).play({.clip = 2, .fade = ticks_per_second / 2});
  crowd.step(3);
  crowd->agent(1).play({.clip = 3, .fade = ticks_per_second / 4});
  ASSERT_TRUE(crowd->agent(2).add_channel(std::make_unique<SimpleChannel>(PlayerStart{.clip = 1})));
  crowd->agent(3).play({.clip = 4});
}

TEST(Agent, IsSetWithManyOthersAsAlone) {
  constexpr std::uint32_t agents = 600;
  CrowdRig together({.pus = 2}, agents), alone({}, agents);
  std::vector<SpeedRequest> speeds;
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    speeds.push_back({.agent = {agent}, .speed = 0.5F + static_cast<float>(agent % 7) / 4.0F});
    for (CrowdRig* crowd : {&together, &alone}) (*crowd)->agent(agent).play({.clip = static_cast<int>(agent % 5)});
  }
  for (CrowdRig* crowd : {&together, &alone}) ask_for_much(*crowd);
  EXPECT_TRUE(together->many().set_speeds(speeds));
  for (const SpeedRequest& each : speeds) alone->agent(each.agent).set_speed(static_cast<double>(each.speed));
  for (CrowdRig* crowd : {&together, &alone}) crowd->step(40);
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    ASSERT_TRUE(together.bones_unlike(alone, agent).empty()) << "agent " << agent;
  }
}

TEST(Agent, IsLeftOutOfManyIfItCannotPlayAtASpeed) {
  const HeardMisuses heard;
  CrowdRig crowd({}, 3);
  crowd->agent(0).play({.clip = 0});
  crowd->agent(2).play({.clip = 0});
  const std::array speeds{SpeedRequest{{0}, 0.0F}, SpeedRequest{{1}, 0.0F}, SpeedRequest{{2}, 1e9F}};
  EXPECT_FALSE(crowd->many().set_speeds(speeds));
  EXPECT_EQ(HeardMisuses::all().size(), 1U);
  crowd->agent(1).play({.clip = 0});
  crowd.step(2);
  EXPECT_EQ(position_of(crowd, 0), 0);
  EXPECT_EQ(position_of(crowd, 2), 2 * frame_ticks * fine_ticks_per_tick);
}

TEST(Agent, HandsTheChannelsThatItHasOut) {
  CrowdRig crowd = two_agents();
  ASSERT_TRUE(crowd->agent(0).add_channel(std::make_unique<SimpleChannel>(PlayerStart{.clip = 1})));
  EXPECT_EQ(crowd->agent(0).channel_count(), 2U);
  EXPECT_EQ(crowd->agent(1).channel_count(), 1U);
  const Handle top = crowd->agent(0).channel<SimpleChannel>({1})->state();
  crowd->agent(0).remove_channel({0});
  EXPECT_EQ(crowd->agent(0).channel(crowd->agent(0).channel_id(0))->state(), top) << "it moved up";
}

TEST(Agent, GivesAPostProcessToAnother) {
  CrowdRig crowd = two_agents();
  const auto added = crowd->agent(0).add_post_process(std::make_unique<NoiseProcess>(NoiseProcess::Settings{}));
  ASSERT_TRUE(added);
  const NoiseProcess* const noise = crowd->agent(0).post_process<NoiseProcess>(*added);
  const auto given = crowd->agent(1).add_post_process(crowd->agent(0).take_post_process<NoiseProcess>(*added));
  ASSERT_TRUE(given);
  EXPECT_EQ(crowd->agent(0).post_process_count(), 0U);
  EXPECT_EQ(crowd->agent(1).post_process<NoiseProcess>(*given), noise);
  crowd->agent(1).remove_post_process(*given);
  EXPECT_EQ(crowd->agent(1).post_process_count(), 0U);
}

}  // namespace
}  // namespace throng::anim::agent_test
