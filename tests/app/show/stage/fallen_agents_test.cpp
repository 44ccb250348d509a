#include "app/show/stage/fallen_agents.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <numeric>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "throng/heap_pages.h"

#include "app/show/camera/fly_camera.h"
#include "app/show/stage/stage.h"
#include "app/window/selection_reporter.h"

namespace throng::app::fallen_agents_test {
namespace {

using Phase = FallenAgents::Phase;

constexpr Ticks frame = ticks_per_second / 60;
constexpr int a_minute = 3600;

/// A dozen mannequins, without a picture.
class PushedOnStage : public testing::Test {
 protected:
  explicit PushedOnStage(const Tuning& tuning = {.scene = Scene::plaza,
                                                 .agents = 12,
                                                 .lod = {.rule = LodRule::distance, .smooth = true},
                                                 .system = {.pus = 2}}) {
    std::vector<CharacterSource> characters;
    characters.push_back(*load_character(THRONG_SOURCE_DIR "/assets/mannequin.glb", "mannequin"));
    auto made = Stage::create(std::move(characters), tuning, pages_);
    EXPECT_TRUE(made);
    stage_ = std::move(*made);
    pass(30);
  }

  void pass(int frames) {
    for (int i = 0; i < frames; ++i) {
      stage_->move(frame);
      stage_->pose(camera_, 1280, 720, frame, stage_->posed().frame());
    }
  }
  /// Frames until it holds; a minute of them if it never does.
  int pass_until(const std::function<bool()>& holds) {
    int frames = 0;
    for (; frames < a_minute && !holds(); ++frames) pass(1);
    return frames;
  }
  bool push(std::uint32_t agent) { return static_cast<bool>(stage_->animated().push_over(agent, {0.0F, 0.0F, -1.0F})); }
  Phase phase(std::uint32_t agent) const { return stage_->animated().fallen().phase(agent); }
  std::size_t blocks(const std::string& kind) const {
    const auto kinds = stage_->system().figures().memory();
    const auto found = std::ranges::find(kinds, kind, &anim::KindMemory::kind);
    return found == kinds.end() ? 0 : found->own.blocks_alive;
  }

  HeapPageSource pages_{std::size_t{1} << 20U};
  std::unique_ptr<Stage> stage_;
  render::Camera camera_ = camera_at({.x = 0, .y = 12, .z = 25, .yaw = 0, .pitch = -25});
};

TEST_F(PushedOnStage, FallsLiesTwoSecondsAndGetsUp) {
  const std::uint32_t agent = 3;
  const glm::vec3 place = stage_->crowd().positions()[agent];
  ASSERT_TRUE(push(agent));
  EXPECT_EQ(blocks("rag-doll"), 1U);
  EXPECT_LT(pass_until([&] { return phase(agent) == Phase::down; }), 30);
  EXPECT_LT(pass_until([&] { return stage_->animated().fallen().at_rest(agent); }), 12 * 60);
  EXPECT_NEAR(pass_until([&] { return phase(agent) == Phase::recovering; }), 120, 1);
  EXPECT_EQ(stage_->crowd().positions()[agent], place) << "until it stands it stays there";
  EXPECT_LE(pass_until([&] { return phase(agent) == Phase::standing; }), 62);
  EXPECT_FALSE(stage_->crowd().minds().holds(agent));
  EXPECT_EQ(blocks("rag-doll"), 0U);
}

TEST_F(PushedOnStage, IsPosedEveryFrameWithAllBonesInViewAndOut) {
  const std::uint32_t agent = 3;
  ASSERT_TRUE(push(agent));
  pass_until([&] { return phase(agent) == Phase::down; });
  for (int i = 0; i < 30; ++i) {
    const Ticks clock = stage_->system().clock();
    pass(1);
    const ShownPose& pose = stage_->posed().shown().pose(agent);
    ASSERT_TRUE(pose.shown());
    EXPECT_EQ(pose.to_level, 0);
    EXPECT_EQ(pose.to_time, stage_->now());
    EXPECT_GT(stage_->system().clock(), clock);
  }
  camera_ = camera_at({.x = 0, .y = 500, .z = 0, .pitch = 80});
  pass(2);
  ASSERT_TRUE(stage_->posed().selection().visible.empty());
  EXPECT_EQ(stage_->system().figures().report().agents_updated, 1U);
  EXPECT_LT(pass_until([&] { return phase(agent) == Phase::standing; }), 20 * 60) << "it gets up unseen";
}

TEST_F(PushedOnStage, CanBeClickedAtWhereItLies) {
  const std::uint32_t agent = 3;
  const auto body = [&] {
    const auto bodies = bodies_in_view(*stage_);
    return *std::ranges::find(bodies, agent, &UprightBody::agent);
  };
  const UprightBody upright = body();
  EXPECT_NEAR(upright.height, 1.8F, 0.3F);
  ASSERT_TRUE(push(agent));
  pass(120);
  EXPECT_LT(body().height, upright.height / 2.0F);
  EXPECT_GT(body().radius, upright.radius);
}

TEST_F(PushedOnStage, CanBePushedAgainWhileItLies) {
  ASSERT_TRUE(push(3));
  pass(60);
  ASSERT_TRUE(push(3));
  pass(30);
  EXPECT_EQ(phase(3), Phase::down);
  EXPECT_EQ(blocks("rag-doll"), 1U);
}

TEST_F(PushedOnStage, EveryoneCanLieAtOnceAndANewCrowdStands) {
  for (std::uint32_t agent = 0; agent < 12; ++agent) ASSERT_TRUE(push(agent));
  pass(60);
  EXPECT_EQ(blocks("rag-doll"), 12U);
  Tuning tuning = stage_->tuning();
  tuning.seed = 9;
  stage_->select(3);
  ASSERT_TRUE(stage_->apply(tuning));
  EXPECT_EQ(blocks("rag-doll"), 0U);
  EXPECT_EQ(phase(3), Phase::standing);
  EXPECT_FALSE(stage_->selected());
  pass(5);
}

TEST_F(PushedOnStage, SchedulesAndStreamsChangeWhileItLies) {
  ASSERT_TRUE(push(3));
  pass(60);
  for (const anim::Schedule schedule : {anim::Schedule::levels, anim::Schedule::fused}) {
    for (const anim::StreamKind stream : {anim::StreamKind::keyframe, anim::StreamKind::sampled}) {
      Tuning tuning = stage_->tuning();
      tuning.system.schedule = schedule;
      tuning.system.stream = stream;
      ASSERT_TRUE(stage_->apply(tuning));
      pass(10);
      EXPECT_EQ(phase(3), Phase::down);
    }
  }
}

TEST_F(PushedOnStage, IsLeftStandingWhereTheStoreHasNoRoomForARagDoll) {
  Tuning tuning = stage_->tuning();
  int kib = 8;
  for (set_local_store_kib(tuning, kib); !stage_->apply(tuning); set_local_store_kib(tuning, ++kib)) ASSERT_LT(kib, 64);
  const Status pushed = stage_->animated().push_over(3, {0.0F, 0.0F, -1.0F});
  ASSERT_FALSE(pushed);
  EXPECT_NE(pushed.error().message.find("local store"), std::string::npos) << pushed.error().message;
  EXPECT_FALSE(stage_->crowd().minds().holds(3));
  pass(60);
}

TEST_F(PushedOnStage, SelectionReportHasTheGraphSourcesFirst) {
  EXPECT_FALSE(report_selection(*stage_));
  stage_->select(3);
  const auto upright = report_selection(*stage_);
  ASSERT_TRUE(upright);
  EXPECT_EQ(upright->agent, 3U);
  EXPECT_EQ(upright->posture, Posture::upright);
  EXPECT_EQ(upright->channels, 1);
  ASSERT_FALSE(upright->entities.empty());
  EXPECT_EQ(upright->entities.front().priority, 0);
  EXPECT_FALSE(upright->entities.front().clip.empty());
  EXPECT_EQ(upright->entities.back().weight, 1.0F);
  ASSERT_TRUE(push(3));
  pass_until([&] { return stage_->animated().fallen().at_rest(3); });
  const auto down = report_selection(*stage_);
  EXPECT_EQ(down->posture, Posture::down);
  EXPECT_EQ(down->interval, 1);
  const auto ragdoll = std::ranges::find(down->entities, "rag-doll", &EntityRow::kind);
  ASSERT_NE(ragdoll, down->entities.end());
  EXPECT_EQ(ragdoll->weight, 1.0F);
  EXPECT_TRUE(ragdoll->resident);
}

TEST_F(PushedOnStage, WeightsOfThePlayersAreAllOfThePose) {
  int fades = 0;
  for (int i = 0; i < 1800; ++i) {
    pass(1);
    stage_->select(static_cast<std::uint32_t>(i % 12));
    const auto report = report_selection(*stage_);
    float sum = 0.0F;
    std::size_t bytes = 0;
    for (const EntityRow& row : report->entities) {
      sum += row.clip.empty() ? 0.0F : row.weight;
      bytes += row.block.size();
    }
    ASSERT_NEAR(sum, 1.0F, 1e-5F);
    ASSERT_EQ(bytes, report->bytes);
    fades += report->entities.size() >= 3 ? 1 : 0;
  }
  EXPECT_GT(fades, 10) << "nobody ever faded";
}

}  // namespace
}  // namespace throng::app::fallen_agents_test
