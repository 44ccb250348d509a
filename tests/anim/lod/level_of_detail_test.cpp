// Level of detail from frame to frame, as a program uses it.

#include "engine/anim/lod/level_of_detail.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace throng::anim::level_of_detail_test {
namespace {

constexpr Ticks frame_step = ticks_per_second / 60;
constexpr std::array<SkipError, 1> walk{};

/// Agents in a row that leads away from a camera at the origin, which looks along -Z; one a metre.
struct Row : testing::Test {
  std::vector<glm::vec3> positions;
  std::vector<float> scales;
  std::vector<std::uint8_t> left_out;
  LevelOfDetail lod;
  LodRequest request;
  InOrder executor;
  std::array<std::byte, 64> memory{};

  Row() {
    request.camera.frustum.fill({0.0F, 0.0F, -1.0F, 0.0F});
    request.camera.pixels_per_unit = 800.0F;
    request.rules = {.rule = LodRule::distance, .smooth = true};
    request.frame_step = frame_step;
    lod.set_characters({{.centre_height = 0.0F,
                         .radius = 1.0F,
                         .level_count = max_bone_levels,
                         .level_error_metres = {0.0F, 0.002F, 0.01F, 0.05F},
                         .update_nanoseconds = {1600, 1200, 800, 400},
                         .clips = walk}});
    stand(100);
  }

  void stand(std::size_t agents) {
    positions.clear();
    for (std::size_t i = 0; i < agents; ++i) positions.push_back({0.0F, 0.0F, -1.0F - static_cast<float>(i)});
    scales.assign(agents, 1.0F);
    left_out.assign(agents, 0);
    lod.reset(agents, request.rules);
  }

  std::span<PoseRequest> select() {
    request.now += request.frame_step;
    lod.select({.positions = positions, .scales = scales, .left_out = left_out}, request, executor, 1);
    return lod.updates();
  }

  /// Every agent that is updated gets a palette, but for `undrawn`.
  void pass_frame(std::uint32_t undrawn = UINT32_MAX) {
    for (PoseRequest& update : select()) {
      if (update.agent.number != undrawn) update.palette = memory.data();
    }
    lod.settle(1000.0);
  }

  const PoseRequest* update_of(std::uint32_t agent) {
    const auto found = std::ranges::find(lod.updates(), AgentId{agent}, &PoseRequest::agent);
    return found == lod.updates().end() ? nullptr : &*found;
  }
  /// Passes frames until it is an agent's turn.
  PoseRequest next_update_of(std::uint32_t agent) {
    for (int i = 0; i < longest_interval; ++i) {
      pass_frame();
      if (update_of(agent) != nullptr) return *update_of(agent);
    }
    ADD_FAILURE() << "agent " << agent << " is never due";
    return {};
  }
};

TEST_F(Row, ComesIntoViewAtOnceAndLooksAheadFromThere) {
  pass_frame();
  ASSERT_EQ(lod.updates().size(), 100U);
  EXPECT_TRUE(
      std::ranges::all_of(lod.updates(), [](const PoseRequest& update) { return update.look_ahead == Ticks{}; }));
  const PoseRequest far = next_update_of(90);
  EXPECT_EQ(far.look_ahead % frame_step, Ticks{});
  EXPECT_GT(far.look_ahead, frame_step);
  EXPECT_EQ(next_update_of(1).look_ahead, Ticks{}) << "near by, posed in each frame";
}

TEST_F(Row, IsDueInTheFirstFrameAtTheEndOfItsBlendHoweverLongFramesAre) {
  constexpr std::array<int, 7> parts{10, 4, 16, 10, 7, 14, 9};  // tenths of a frame
  std::vector<Ticks> ends(positions.size());
  int blends = 0;
  for (int i = 0; i < 400; ++i) {
    request.frame_step = frame_step * parts[static_cast<std::size_t>(i) % parts.size()] / 10;
    pass_frame();
    for (std::size_t agent = 0; agent < ends.size(); ++agent) {
      const PoseRequest* const update = update_of(static_cast<std::uint32_t>(agent));
      if (ends[agent] > Ticks{}) {
        ASSERT_EQ(update != nullptr, request.now >= ends[agent]) << "agent " << agent << " in frame " << i;
      }
      if (update == nullptr) continue;
      blends += ends[agent] > Ticks{} ? 1 : 0;
      ends[agent] = update->look_ahead > Ticks{} ? request.now + update->look_ahead : Ticks{};
    }
  }
  EXPECT_GT(blends, 1000);
}

TEST_F(Row, AnAgentWithoutPaletteHasNothingToBlendFrom) {
  for (int i = 0; i < 40; ++i) {
    pass_frame(90);
    EXPECT_FALSE(lod.is_shown(90));
    if (const PoseRequest* update = update_of(90)) {
      EXPECT_EQ(update->look_ahead, Ticks{});
    }
  }
  EXPECT_TRUE(lod.is_shown(89));
}

TEST_F(Row, AnUpdateThatCannotBlendIsOfNowAndIsDueAgainInTheNextFrame) {
  pass_frame();
  for (bool met = false; !met;) {
    for (PoseRequest& update : select()) {
      update.palette = memory.data();
      if (update.agent.number != 90 || update.look_ahead == Ticks{}) continue;
      lod.show_at_once(update);
      EXPECT_EQ(update.look_ahead, Ticks{});
      met = true;
    }
    lod.settle(1000.0);
  }
  pass_frame();
  EXPECT_NE(update_of(90), nullptr);
}

TEST_F(Row, BoneLevelsChangeByStepsWhereTheAgentIsShownAndAtOnceElsewhere) {
  request.rules.level_distances = {200.0F, 300.0F, 400.0F};
  pass_frame();
  EXPECT_EQ(update_of(50)->level, 0);
  request.rules.level_distances = {15.0F, 20.0F, 30.0F};
  EXPECT_EQ(next_update_of(50).fade_halves, 1);
  EXPECT_EQ(next_update_of(50).fade_halves, 2);
  EXPECT_EQ(next_update_of(50).level, 3);
  request.rules.level_distances = {200.0F, 300.0F, 400.0F};
  lod.forget_shown();
  const PoseRequest anew = next_update_of(50);
  EXPECT_EQ(anew.level, 0);
  EXPECT_EQ(anew.fade_halves, 0);
}

TEST_F(Row, LeftOutAgentsAreUpdatedByHandAlone) {
  left_out[3] = 1;
  pass_frame();
  EXPECT_EQ(update_of(3), nullptr);
  select();
  lod.update_also(3).palette = memory.data();
  lod.settle(1000.0);
  ASSERT_NE(update_of(3), nullptr);
  EXPECT_EQ(update_of(3)->level, 0);
  EXPECT_TRUE(lod.is_shown(3));
}

TEST_F(Row, ABudgetHoldsFromTheFirstFrame) {
  request.rules.rule = LodRule::budget;
  request.rules.error_pixels = 0.0F;
  request.rules.budget_milliseconds = 0.02;
  stand(100);
  pass_frame();
  EXPECT_GT(lod.figures().tolerance_px, least_tolerance_pixels);
  EXPECT_EQ(lod.figures().binding, BindingLimit::budget);
  EXPECT_TRUE(lod.figures().budget_held);
}

TEST_F(Row, TheSelectedAgentIsPosedMoreOften) {
  request.rules.rule = LodRule::budget;
  for (int i = 0; i < 30; ++i) pass_frame();
  const LodChoice before = lod.choice(60);
  request.selected = 60;
  for (int i = 0; i < 2 * longest_interval; ++i) pass_frame();
  const LodChoice after = lod.choice(60);
  EXPECT_LE(after.interval, before.interval);
  EXPECT_LT(after.interval * 10 + after.bone_level, before.interval * 10 + before.bone_level);
}

TEST_F(Row, AfterARestartTheSameFramesAreDecidedTheSame) {
  request.rules.rule = LodRule::budget;
  const auto run = [&](Ticks first_step) {
    lod.restart();
    stand(100);
    std::vector<std::pair<std::uint32_t, Ticks>> decided;
    for (int i = 0; i < 30; ++i) {
      request.frame_step = i == 0 ? first_step : frame_step;
      pass_frame();
      for (const PoseRequest& update : lod.updates()) decided.emplace_back(update.agent.number, update.look_ahead);
    }
    return decided;
  };
  const auto first = run(frame_step * 6 / 5);
  run(frame_step * 7 / 10);  // choices are built for the usual frame from its second one on
  EXPECT_EQ(run(frame_step * 6 / 5), first);
}

TEST_F(Row, WhileTimeStandsStillNoTurnComesAndNoFigureChanges) {
  for (int i = 0; i < 20; ++i) pass_frame();
  const double predicted = lod.figures().predicted_ms;
  request.frame_step = Ticks{};
  select();
  lod.settle(5e6);
  EXPECT_EQ(lod.figures().predicted_ms, predicted);
  select();
  EXPECT_TRUE(lod.updates().empty());
}

}  // namespace
}  // namespace throng::anim::level_of_detail_test
