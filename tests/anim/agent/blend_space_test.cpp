// Walk, jog and run by speed, feet together.

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/agent/blend_space_channel.h"
#include "tests/anim/agent/crowd_rig.h"

namespace throng::anim::blend_space_test {
namespace {

// Clips of 0.9, 1 and 1.1 s: seconds a cycle differ, as a walk's and a run's do.
constexpr BlendPoint walk{.clip = 4, .parameter = 1.4F};
constexpr BlendPoint jog{.clip = 3, .parameter = 2.6F};
constexpr BlendPoint run{.clip = 0, .parameter = 4.2F};

struct Runner {
  explicit Runner(float speed, const SystemOptions& options = {}) : crowd(options) {
    const Result<ChannelId> added =
        crowd->agent(0).add_channel(std::make_unique<BlendSpaceChannel>(std::vector{walk, jog, run}, speed, true));
    EXPECT_TRUE(added) << added.error().message;
  }
  void set_speed(float speed) {
    const Status changed = crowd->agent(0).change<BlendSpaceChannel>(
        {0}, [&](BlendSpaceChannel& channel) { channel.set_parameter(speed); });
    EXPECT_TRUE(changed) << changed.error().message;
  }
  /// Where each player is in its cycle, 0 to 1.
  std::vector<double> phases() const {
    std::vector<double> phases;
    for (const Handle entity : crowd->agent(0).graph().entities) {
      if (crowd->characters().pools(0).state(entity).type != EntityType::sampled_player) continue;
      const auto& player = crowd->characters().pools(0).as<Player>(entity);
      const auto duration = static_cast<double>(test_character()->clips[player.clip].duration.count());
      phases.push_back(static_cast<double>(player.position) / static_cast<double>(fine_ticks_per_tick.count()) /
                       duration);
    }
    return phases;
  }
  double out_of_step() const {
    const std::vector<double> now = phases();
    return now.size() < 2 ? 0.0 : std::abs(std::remainder(now[0] - now[1], 1.0));
  }
  CrowdRig crowd;
};

TEST(BlendSpace, AtAPointPlaysItsClipAlone) {
  for (const BlendPoint& point : {walk, jog, run}) {
    Runner runner(point.parameter);
    runner.crowd.step(20);
    EXPECT_EQ(runner.crowd.entities(), 1U);
    CrowdRig plain;
    plain->agent(0).play({.clip = point.clip});
    plain.step(20);
    EXPECT_TRUE(runner.crowd.bones_unlike(plain).empty());
  }
}

TEST(BlendSpace, BetweenTwoPointsBlendsThem) {
  Runner runner(2.0F);
  runner.crowd.step(20);
  EXPECT_EQ(runner.crowd.entities(), 3U);
  const auto& blender = runner.crowd->characters().pools(0).as<EaseBlender>(runner.crowd->agent(0).graph().root());
  EXPECT_NEAR(blender.fraction, 0.5F, 1e-6F);
}

TEST(BlendSpace, OutsideItsPointsPlaysTheNearestAtThePaceOfTheSpeed) {
  Runner slow(0.7F);
  slow.crowd.step(1);
  EXPECT_EQ(slow.crowd.entities(), 1U);
  const auto& player = slow.crowd->characters().pools(0).as<Player>(slow.crowd->agent(0).graph().root());
  EXPECT_NEAR(player.speed / 65536.0, 0.5, 1e-4) << "half as fast as the walk was made";
}

TEST(BlendSpace, KeepsPhasesAlignedAfterMinutesOfChangingSpeed) {
  Runner runner(1.0F);
  std::mt19937 random(5);
  float speed = 1.0F;
  double farthest = 0.0;
  for (int frame = 0; frame < 3 * 60 * 60; ++frame) {
    if (frame % 7 == 0) {
      const float wanted = static_cast<float>(random() % 500U) * 0.01F;
      speed += std::clamp(wanted - speed, -0.2F, 0.2F);
      runner.set_speed(speed);
    }
    runner.crowd.step();
    farthest = std::max(farthest, runner.out_of_step());
  }
  EXPECT_LT(farthest, 1e-3);
}

TEST(BlendSpace, KeepsPhasesAlignedAfterAnHourOfOneSpeed) {
  Runner runner(1.9F);
  const PoseRequest update{.agent = {0}};
  double farthest = 0.0;
  for (int second = 0; second < 3600; ++second) {
    runner.crowd->advance(ticks_per_second);
    runner.crowd->update({&update, 1});
    farthest = std::max(farthest, runner.out_of_step());
  }
  EXPECT_LT(farthest, 1e-3);
}

TEST(BlendSpace, DoesNotSnapWhenTheSpeedCrossesAPoint) {
  Runner runner(2.59F);
  runner.crowd.step(30);
  std::vector<glm::vec3> before = runner.crowd.joints();
  float usual = 0.0F;
  float crossing = 0.0F;
  for (int frame = 0; frame < 60; ++frame) {
    if (frame == 30) runner.set_speed(2.61F);
    runner.crowd.step();
    const std::vector<glm::vec3> now = runner.crowd.joints();
    float& largest = frame == 30 ? crossing : usual;
    for (std::size_t i = 0; i < now.size(); ++i) largest = std::max(largest, glm::distance(now[i], before[i]));
    before = now;
  }
  EXPECT_LE(crossing, 1.5F * usual);
}

TEST(BlendSpace, IsTheSameUnderEverySchedule) {
  Runner fused(1.5F);
  Runner levels(1.5F, {.schedule = Schedule::levels});
  for (Runner* runner : {&fused, &levels}) {
    for (int i = 0; i < 20; ++i) {
      runner->set_speed(1.5F + 0.1F * static_cast<float>(i));
      runner->crowd.step(10);
    }
  }
  EXPECT_EQ(fused.crowd->figures().pose_hash(), levels.crowd->figures().pose_hash());
}

}  // namespace
}  // namespace throng::anim::blend_space_test
