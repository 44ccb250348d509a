#include "engine/anim/lod/lod.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace throng::anim::lod_test {
namespace {

// A crowd seen by a camera at the origin that looks along -Z and sees everything before it.
struct LodTest : testing::Test {
  std::vector<glm::vec3> positions;
  std::vector<float> scales;
  LodCharacter character{.centre_height = 0.0F, .radius = 1.0F, .height = 1.8F};
  LodFrame frame;
  LodState state;
  LodSelection selection;

  LodTest() {
    frame.characters = {&character, 1};
    frame.camera.frustum.fill({0.0F, 0.0F, -1.0F, 0.0F});
    frame.rules = {.rule = LodRule::distance, .smooth = true};
    frame.camera.pixels_per_unit = 800.0F;
    frame.number = 100;
  }

  void spawn(std::size_t agents, float distance) {
    positions.assign(agents, glm::vec3(0.0F, 0.0F, -distance));
    scales.assign(agents, 1.0F);
    state.resize(agents, selection);
  }

  void select() {
    frame.positions = positions;
    frame.scales = scales;
    select_for_update(frame, state, selection);
  }

  void select_next() {
    ++frame.number;
    select();
  }

  bool is_due(std::uint32_t agent) const { return std::ranges::find(selection.due, agent) != selection.due.end(); }

  /// Turns until the next update of an agent that is due; 0: the next frame.
  int look_ahead(std::uint32_t agent) const { return static_cast<int>(state.next_update[agent] - frame.number); }

  VisibleAgent decide_afresh(float distance) {
    spawn(1, distance);
    select();
    return selection.visible.front();
  }
};

TEST_F(LodTest, AgentsNearerThanTheFullRateDistanceAreUpdatedEachFrame) {
  spawn(10, std::nextafter(12.0F, 0.0F));
  for (int i = 0; i < 20; ++i) {
    select_next();
    ASSERT_EQ(selection.due.size(), 10U);
    for (const std::uint32_t agent : selection.due) EXPECT_EQ(look_ahead(agent), 0);
  }
}

TEST_F(LodTest, TheIntervalGrowsExactlyAtEachThreshold) {
  for (int steps = 0; steps < 7; ++steps) {
    const float threshold = 12.0F + 12.0F * static_cast<float>(steps);
    EXPECT_EQ(decide_afresh(std::nextafter(threshold, 0.0F)).interval, steps + 1);
    EXPECT_EQ(decide_afresh(threshold).interval, steps + 2);
  }
}

TEST_F(LodTest, TheIntervalStopsAtTheLargest) {
  EXPECT_EQ(decide_afresh(10'000.0F).interval, 8);
  frame.rules.largest_interval = longest_interval;
  EXPECT_EQ(decide_afresh(10'000.0F).interval, longest_interval);
  frame.rules.largest_interval = 1;
  EXPECT_EQ(decide_afresh(10'000.0F).interval, 1);
}

TEST_F(LodTest, BoneLevelsBeginExactlyAtTheirDistances) {
  int level = 0;
  for (const float threshold : frame.rules.level_distances) {
    EXPECT_EQ(decide_afresh(std::nextafter(threshold, 0.0F)).bone_level, level);
    EXPECT_EQ(decide_afresh(threshold).bone_level, ++level);
  }
}

TEST_F(LodTest, BoneLevelsStayWithinWhatTheCharacterHas) {
  character.level_count = 2;
  EXPECT_EQ(decide_afresh(1'000.0F).bone_level, 1);
  frame.rules.bone_lod = false;
  EXPECT_EQ(decide_afresh(1'000.0F).bone_level, 0);
}

TEST_F(LodTest, TheWorkOfEachFrameIsEvenAfterEveryoneAppearedAtOnce) {
  spawn(1000, 40.0F);  // interval 4
  select();
  EXPECT_EQ(selection.due.size(), 1000U);
  select_next();
  EXPECT_EQ(selection.due.size(), 1000U);
  for (int i = 0; i < 3; ++i)
    select_next();  // the first look ahead is shortened, so that each agent meets its own turn
  for (int i = 0; i < 40; ++i) {
    select_next();
    EXPECT_EQ(selection.due.size(), 250U) << "frame " << frame.number;
    for (const std::uint32_t agent : selection.due) EXPECT_EQ(look_ahead(agent), 4);
  }
}

TEST_F(LodTest, EachUpdateLooksAheadExactlyToTheNext) {
  spawn(64, 0.0F);
  for (std::size_t agent = 0; agent < 64; ++agent) positions[agent].z = -2.0F * static_cast<float>(agent);
  std::vector<std::uint64_t> expected(64, frame.number);
  select();
  for (int i = 0; i < 100; ++i, select_next()) {
    std::vector<bool> due(64, false);
    for (const std::uint32_t agent : selection.due) {
      due[agent] = true;
      EXPECT_EQ(frame.number, expected[agent]);
      expected[agent] = std::max(state.next_update[agent], frame.number + 1);
    }
    for (std::size_t agent = 0; agent < 64; ++agent) EXPECT_TRUE(due[agent] || expected[agent] > frame.number);
    for (glm::vec3& position : positions) position.z *= 1.005F;
  }
}

TEST_F(LodTest, AgentsOffScreenAreNeitherVisibleNorDue) {
  spawn(3, 20.0F);
  positions[1].z = 1.1F;  // behind the camera by more than the radius
  select();
  ASSERT_EQ(selection.visible.size(), 2U);
  ASSERT_EQ(selection.due.size(), 2U);
  EXPECT_EQ(selection.visible[1].agent, 2U);
  EXPECT_EQ(selection.due[1], 2U);
}

TEST_F(LodTest, AnAgentWhoseSphereReachesIntoViewIsVisible) {
  spawn(1, -0.99F);
  select();
  EXPECT_EQ(selection.visible.size(), 1U);
  scales[0] = 0.9F;  // the sphere shrinks with the agent
  select_next();
  EXPECT_TRUE(selection.visible.empty());
}

TEST_F(LodTest, AnAgentThatReappearsIsDueAtOnce) {
  spawn(8, 100.0F);
  for (int i = 0; i < 3; ++i) select_next();
  positions[5].z = 10.0F;
  select_next();
  positions[5].z = -100.0F;
  select_next();
  EXPECT_TRUE(is_due(5));
}

TEST_F(LodTest, AnAgentThatReappearsLooksAheadFromTheNextFrame) {
  spawn(1, 100.0F);
  select();
  ASSERT_TRUE(is_due(0));
  EXPECT_EQ(look_ahead(0), 0);
  select_next();
  ASSERT_TRUE(is_due(0));
  EXPECT_EQ(look_ahead(0), 8 - static_cast<int>(frame.number % 8));
}

TEST_F(LodTest, WhileTimeStandsStillNobodyIsDueTwiceUnlessAllAreMadeDue) {
  spawn(8, 100.0F);
  select();
  EXPECT_EQ(selection.due.size(), 8U);
  frame.stands_still = true;
  select();
  EXPECT_TRUE(selection.due.empty());
  frame.rules.largest_interval = 2;
  state.make_all_due();
  select();
  EXPECT_EQ(selection.due.size(), 8U);
  EXPECT_EQ(selection.visible[0].interval, 2);
}

TEST_F(LodTest, WhoIsMadeDueIsPosedOutOfTurnAsOfNowAndAheadFromTheNextFrameOn) {
  spawn(8, 100.0F);
  select();
  select_next();
  select_next();
  const std::uint32_t agent = (frame.number + 4) % 8;  // whose turn is far off
  state.make_due(agent);
  select_next();
  ASSERT_TRUE(is_due(agent));
  EXPECT_EQ(look_ahead(agent), 0);
  select_next();
  ASSERT_TRUE(is_due(agent));
  EXPECT_GT(look_ahead(agent), 1);
  select_next();
  EXPECT_FALSE(is_due(agent));
}

TEST_F(LodTest, WithLodOffEveryoneIsPosedWithAllBonesAndOnlyTheVisibleAreReportedSo) {
  frame.rules.rule = LodRule::off;
  frame.rules.bone_lod = false;
  spawn(20, 500.0F);
  positions[7].z = 500.0F;
  for (int i = 0; i < 5; ++i) {
    select_next();
    ASSERT_EQ(selection.due.size(), 20U);
    for (const std::uint32_t agent : selection.due) {
      EXPECT_EQ(look_ahead(agent), 0);
      EXPECT_EQ(state.bone_level[agent], 0);
    }
    EXPECT_EQ(selection.visible.size(), 19U);
  }
}

TEST_F(LodTest, WithTheRuleOffBoneLevelsStillFollowDistanceAndEveryoneIsPosedEachFrame) {
  frame.rules.rule = LodRule::off;
  spawn(4, 5.0F);
  positions[1].z = -20.0F;
  positions[2].z = -100.0F;
  positions[3].z = 100.0F;  // behind the camera
  for (int i = 0; i < 5; ++i) {
    select_next();
    ASSERT_EQ(selection.due.size(), 4U);
    const std::array expected = {0, 1, 3, 3};
    for (const std::uint32_t agent : selection.due) {
      EXPECT_EQ(look_ahead(agent), 0);
      EXPECT_EQ(state.bone_level[agent], expected[agent]) << "agent " << agent;
    }
    ASSERT_EQ(selection.visible.size(), 3U);
    EXPECT_EQ(selection.visible[2].interval, 1);
    EXPECT_EQ(selection.visible[2].bone_level, 3);
  }
}

TEST_F(LodTest, ABoneLevelDoesNotFlickerAboutItsDistance) {
  frame.rules.largest_interval = 1;
  spawn(1, 14.9F);
  select();
  int changes = 0;
  int level = selection.visible[0].bone_level;
  for (int i = 0; i < 50; ++i) {
    positions[0].z = i % 2 == 0 ? -15.1F : -13.6F;  // 13.5 m is a tenth nearer than 15
    select_next();
    if (selection.visible[0].bone_level != level) ++changes;
    level = selection.visible[0].bone_level;
  }
  EXPECT_EQ(level, 1);
  EXPECT_EQ(changes, 1);
  positions[0].z = -13.4F;
  select_next();
  EXPECT_EQ(selection.visible[0].bone_level, 0);
}

TEST_F(LodTest, IntervalAndLevelChangeOnlyAtAnUpdate) {
  spawn(1, 100.0F);
  for (int i = 0; i < 20; ++i) select_next();
  while (selection.due.empty()) select_next();
  positions[0].z = -2.0F;
  for (int i = 1; i < 8; ++i) {
    select_next();
    EXPECT_TRUE(selection.due.empty());
    EXPECT_EQ(selection.visible[0].interval, 8);
    EXPECT_EQ(selection.visible[0].bone_level, 3);
  }
  select_next();
  ASSERT_EQ(selection.due.size(), 1U);
  EXPECT_EQ(selection.visible[0].interval, 1);
  EXPECT_EQ(selection.visible[0].bone_level, 0);
}

TEST_F(LodTest, PixelsTallFollowHeightScaleAndDistance) {
  spawn(1, 40.0F);
  scales[0] = 0.5F;
  select();
  EXPECT_FLOAT_EQ(selection.visible[0].pixels_tall, 1.8F * 0.5F * 800.0F / 40.0F);
}

TEST_F(LodTest, AnAgentIsDecidedAlikeWhoeverElseIsThere) {
  spawn(500, 0.0F);
  for (std::size_t agent = 0; agent < 500; ++agent) positions[agent].z = 5.0F - 0.3F * static_cast<float>(agent);
  LodFrame fewer = frame;
  LodState fewer_state;
  LodSelection fewer_selection;
  fewer_state.resize(200, fewer_selection);
  for (int i = 0; i < 30; ++i) {
    select_next();
    fewer.number = frame.number;
    fewer.positions = frame.positions.first(200);
    fewer.scales = frame.scales.first(200);
    select_for_update(fewer, fewer_state, fewer_selection);
    ASSERT_LE(fewer_selection.due.size(), selection.due.size());
    for (std::size_t due = 0; due < fewer_selection.due.size(); ++due) {
      const std::uint32_t agent = fewer_selection.due[due];
      EXPECT_EQ(agent, selection.due[due]);
      EXPECT_EQ(fewer_state.next_update[agent], state.next_update[agent]);
      EXPECT_EQ(fewer_state.bone_level[agent], state.bone_level[agent]);
    }
    for (glm::vec3& position : positions) position.z += 0.05F;
  }
}

TEST_F(LodTest, ChoosingAllocatesNothing) {
  spawn(100, 5.0F);
  const auto* visible = selection.visible.data();
  const auto* due = selection.due.data();
  for (int i = 0; i < 10; ++i) select_next();
  EXPECT_EQ(selection.visible.data(), visible);
  EXPECT_EQ(selection.due.data(), due);
}

}  // namespace
}  // namespace throng::anim::lod_test
