#include "app/clip_requests.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/asset/synthetic_model.h"

namespace throng::app {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

ClipRequest request(std::uint32_t agent, int clip) {
  return {.agent = agent, .role = Role::other, .clip = clip, .fade_seconds = 0.2F};
}

/// Agents that have no room while they are busy, and what the others were asked to play.
struct Busy {
  std::vector<std::uint32_t> agents;
  std::vector<int> played;

  bool operator()(const ClipRequest& asked) {
    if (std::ranges::find(agents, asked.agent) != agents.end()) return false;
    played.push_back(asked.clip);
    return true;
  }
  std::vector<int> take_played() { return std::exchange(played, {}); }
};

struct ClipRequestsTest : testing::Test {
  ClipRequests requests;
  Busy crowd;

  ClipRequestsTest() { requests.reset(4); }
  void submit(const std::vector<ClipRequest>& asked) {
    requests.submit(asked, [this](const ClipRequest& each) { return crowd(each); });
  }
};

TEST_F(ClipRequestsTest, ArePlayedAtOnceWhereThereIsRoom) {
  submit({request(0, 5), request(1, 6)});
  EXPECT_THAT(crowd.take_played(), ElementsAre(5, 6));
  submit({});
  EXPECT_THAT(crowd.take_played(), IsEmpty()) << "once";
}

TEST_F(ClipRequestsTest, WaitUntilThereIsRoom) {
  crowd.agents = {1};
  submit({request(0, 5), request(1, 6), request(2, 7)});
  EXPECT_THAT(crowd.take_played(), ElementsAre(5, 7));
  submit({});
  EXPECT_THAT(crowd.take_played(), IsEmpty());
  crowd.agents = {};
  submit({});
  EXPECT_THAT(crowd.take_played(), ElementsAre(6));
  EXPECT_EQ(requests.waiting(), 0U);
}

TEST_F(ClipRequestsTest, GiveWayToANewerOneOfTheSameAgent) {
  crowd.agents = {1};
  submit({request(1, 6)});
  submit({request(1, 7)});
  EXPECT_EQ(requests.waiting(), 1U);
  crowd.agents = {};
  submit({});
  EXPECT_THAT(crowd.take_played(), ElementsAre(7));
}

TEST_F(ClipRequestsTest, AreDroppedWhenANewerOneFindsRoom) {
  crowd.agents = {1};
  submit({request(1, 6)});
  crowd.agents = {};
  submit({request(1, 7)});
  EXPECT_THAT(crowd.take_played(), ElementsAre(7));
  submit({});
  EXPECT_THAT(crowd.take_played(), IsEmpty());
}

TEST_F(ClipRequestsTest, AreForgottenWithTheCrowdThatMadeThem) {
  crowd.agents = {1};
  submit({request(1, 6)});
  requests.reset(4);
  crowd.agents = {};
  submit({});
  EXPECT_THAT(crowd.take_played(), IsEmpty());
}

TEST(ClipRequestsOfASystem, ReachATreeThatWasFullWhenAFadeOfItIsOver) {
  const auto character = std::make_shared<const anim::Character>(anim::bake_character(anim::synthetic_model(20, 6)));
  const auto system = std::move(*anim::AnimationSystem::create(character, {}));
  system->set_agent_count(1);
  const auto play = [&](const ClipRequest& asked) {
    return system->play(0, {.clip = asked.clip, .fade = anim::to_ticks(static_cast<double>(asked.fade_seconds))});
  };
  ClipRequests requests;
  requests.reset(1);
  for (int clip = 0; clip < anim::BlendTree::max_players + 1; ++clip) {
    const ClipRequest asked = request(0, clip);
    requests.submit({&asked, 1}, play);
  }
  EXPECT_EQ(requests.waiting(), 1U);
  const anim::AgentUpdate update{.agent = 0};
  for (int frame = 0; frame < 15; ++frame) {
    system->advance(anim::ticks_per_second / 60);
    requests.submit({}, play);
    system->update({&update, 1});
  }
  EXPECT_EQ(requests.waiting(), 0U);
}

}  // namespace
}  // namespace throng::app
