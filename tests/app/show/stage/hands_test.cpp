// What a person does to a stage by hand: hold a clip, take time back, force level of detail.
#include <algorithm>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "app/show/camera/fly_camera.h"
#include "app/show/stage/rewind.h"
#include "app/show/stage/stage.h"
#include "app/window/selection_log.h"
#include "app/window/selection_reporter.h"
#include "tests/app/show/stage/watched_stage.h"

namespace throng::app::hands_test {
namespace {

class StageInHands : public test::WatchedStage {
 protected:
  void SetUp() override { open({.scene = Scene::plaza, .agents = 12, .system = {.pus = 2}}); }

  std::vector<glm::vec3> positions() const {
    return {stage_->crowd().positions().begin(), stage_->crowd().positions().end()};
  }
  /// Of the player of an agent that is heaviest in its pose.
  float position_in_clip(std::uint32_t agent) {
    stage_->select(agent);
    const auto report = report_selection(*stage_);
    const auto& entities = report->entities;
    return std::ranges::max_element(entities, {},
                                    [](const EntityRow& row) { return row.duration_seconds > 0 ? row.weight : -1.0F; })
        ->position_seconds;
  }
};

TEST_F(StageInHands, AHeldClipStandsWhereItIsHeldAndSoDoesItsAgent) {
  const std::uint32_t agent = 2;
  pass(30);
  stage_->select(agent);
  stage_->animated().hold_clip(agent, 0.25F);
  pass(2);
  const glm::vec3 place = stage_->crowd().positions()[agent];
  pass(40);
  EXPECT_NEAR(position_in_clip(agent), 0.25F, 1e-3F);
  EXPECT_EQ(stage_->crowd().positions()[agent], place);
  stage_->animated().hold_clip(agent, 0.5F);
  pass(2);
  EXPECT_NEAR(position_in_clip(agent), 0.5F, 1e-3F);
}

TEST_F(StageInHands, WhoIsLetGoPlaysOn) {
  pass(10);
  stage_->select(2);
  stage_->animated().hold_clip(2, 0.25F);
  pass(5);
  stage_->animated().let_go_of_clip();
  EXPECT_FALSE(stage_->animated().held_clip());
  EXPECT_FALSE(stage_->crowd().minds().holds(2));
  pass(60);
  const float then = position_in_clip(2);
  pass(3);
  EXPECT_NE(position_in_clip(2), then);
}

TEST_F(StageInHands, AnotherSelectionAndAPushLetGo) {
  stage_->select(2);
  stage_->animated().hold_clip(2, 0.25F);
  stage_->select(3);
  EXPECT_FALSE(stage_->animated().held_clip());
  stage_->animated().hold_clip(3, 0.25F);
  ASSERT_TRUE(stage_->animated().push_over(3, {0.0F, 0.0F, -1.0F}));
  EXPECT_FALSE(stage_->animated().held_clip());
  pass(10);
  EXPECT_NE(stage_->animated().fallen().phase(3), FallenAgents::Phase::standing);
  stage_->animated().hold_clip(3, 0.25F);
  EXPECT_FALSE(stage_->animated().held_clip()) << "it has fallen";
}

TEST_F(StageInHands, TakenBackTheCrowdDoesTheSameAgain) {
  pass(80);
  const Ticks kept = stage_->system().clock() - rewind_.age(*stage_);
  const auto frames_since = static_cast<int>(rewind_.age(*stage_) / frame);
  ASSERT_GT(frames_since, 5);
  const auto then = positions();
  ASSERT_TRUE(rewind_.go_back(*stage_));
  EXPECT_EQ(stage_->system().clock(), kept);
  EXPECT_NE(positions(), then);
  pass(frames_since);
  EXPECT_EQ(positions(), then);
}

TEST_F(StageInHands, TakenBackTwiceItStrikesTheSamePosesBothTimes) {
  open({.scene = Scene::plaza,
        .agents = 12,
        .lod = {.rule = LodRule::off, .bone_lod = false, .smooth = true},
        .system = {.pus = 2}});
  pass(40);
  StageMoment moment;
  stage_->animated().remember(moment);
  std::vector<std::uint64_t> hashes;
  for (int time = 0; time < 2; ++time) {
    ASSERT_TRUE(stage_->go_back_to(moment));
    pass(25);
    hashes.push_back(hash());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST_F(StageInHands, EachTimeItGoesFurtherBackUntilNothingIsLeft) {
  pass(200);
  ASSERT_GE(rewind_.count(), 3U);
  Ticks clock = stage_->system().clock();
  while (rewind_.count() > 0) {
    ASSERT_TRUE(rewind_.go_back(*stage_));
    EXPECT_LT(stage_->system().clock(), clock);
    clock = stage_->system().clock();
  }
  EXPECT_FALSE(rewind_.go_back(*stage_));
}

TEST_F(StageInHands, KeepsNoMoreMomentsThanItSays) {
  pass(60 * 8);
  EXPECT_EQ(rewind_.count(), Rewind::most_moments);
  EXPECT_LE(rewind_.age(*stage_), Rewind::time_between);
}

TEST_F(StageInHands, AMomentOfAnotherCrowdIsRefused) {
  pass(40);
  StageMoment moment;
  stage_->animated().remember(moment);
  Tuning other = stage_->tuning();
  other.seed = 5;
  ASSERT_TRUE(stage_->apply(other));
  EXPECT_FALSE(stage_->go_back_to(moment));
  EXPECT_FALSE(rewind_.go_back(*stage_));
  pass(1);
  EXPECT_EQ(rewind_.count(), 1U) << "those of the crowd before are forgotten";
}

TEST_F(StageInHands, WhatIsForcedIsSeenInTheSelection) {
  Tuning tuning = stage_->tuning();
  tuning.lod.rule = LodRule::distance;
  tuning.inspection = {.forced_interval = 6, .forced_bone_level = 1, .force_selected_only = true};
  ASSERT_TRUE(stage_->apply(tuning));
  pass(20);
  const auto forced = [](const anim::VisibleAgent& agent) { return agent.interval == 6; };
  EXPECT_EQ(std::ranges::count_if(stage_->posed().selection().visible, forced), 0) << "nobody is selected";
  stage_->select(stage_->posed().selection().visible.front().agent);
  pass(20);
  EXPECT_EQ(std::ranges::count_if(stage_->posed().selection().visible, forced), 1);
  tuning.inspection.force_selected_only = false;
  ASSERT_TRUE(stage_->apply(tuning));
  pass(20);
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count_if(stage_->posed().selection().visible, forced)),
            stage_->posed().selection().visible.size());
}

TEST_F(StageInHands, TheLogKeepsLevelOfDetailFrameByFrameAndBeginsAnewWithAnotherAgent) {
  SelectionLog log;
  SelectionReport report;
  const auto look = [&](std::uint32_t agent) {
    stage_->select(agent);
    report = *report_selection(*stage_);
    log.update(*stage_, report);
  };
  look(2);
  for (int i = 0; i < 30; ++i) {
    pass(1);
    look(2);
  }
  EXPECT_EQ(report.history.size(), 30U);
  look(2);
  EXPECT_EQ(report.history.size(), 30U) << "no time has passed";
  pass(1);
  look(3);
  EXPECT_LE(report.history.size(), 1U);
}

TEST_F(StageInHands, EveryBlockOfTheSelectedAgentIsReportedByteForByte) {
  pass(10);
  stage_->select(2);
  const auto report = report_selection(*stage_);
  ASSERT_FALSE(report->entities.empty());
  for (const EntityRow& entity : report->entities) {
    const auto size = std::ranges::find(entity.fields, "Total size", &BlockField::name);
    ASSERT_NE(size, entity.fields.end());
    EXPECT_EQ(size->value, std::to_string(entity.block.size()) + " B");
    const auto priority = std::ranges::find(entity.fields, "Priority", &BlockField::name);
    ASSERT_NE(priority, entity.fields.end());
    EXPECT_EQ(priority->value == "highest", entity.priority == 0);
  }
}

}  // namespace
}  // namespace throng::app::hands_test
