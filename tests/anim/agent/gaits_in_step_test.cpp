// Gaits of a blend space keep step, foot by foot. Idle goes on breathing.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/agent/blend_space_channel.h"
#include "tests/anim/agent/gait_crowd.h"
#include "tests/anim/agent/heard_misuses.h"

namespace throng::anim::gaits_in_step_test {
namespace {

const std::vector<BlendPoint> by_speed{{.clip = gaits::idle, .parameter = 0.0F},
                                       {.clip = gaits::walk, .parameter = 1.4F},
                                       {.clip = gaits::jog, .parameter = 2.6F},
                                       {.clip = gaits::run, .parameter = 4.2F}};

struct Walker : GaitCrowd {
  explicit Walker(float speed, std::vector<BlendPoint> points = by_speed, bool is_ground_speed = true) {
    const Status added =
        system->agent(0).add_channel(std::make_unique<BlendSpaceChannel>(std::move(points), speed, is_ground_speed));
    EXPECT_TRUE(added) << added.error().message;
  }
  void set_speed(float speed) {
    const Status changed = system->agent(0).change<BlendSpaceChannel>(
        {0}, [&](BlendSpaceChannel& channel) { channel.set_parameter(speed); });
    EXPECT_TRUE(changed) << changed.error().message;
  }
};

double rate(const Player* player) { return player == nullptr ? 0.0 : player->speed / 65536.0; }

/// Says which foot strikes next, and how much of the way there from the strike before is gone.
struct StepPlace {
  std::string next;
  double gone = 0.0;
};
StepPlace step_place(const Player& player) {
  const BakedClip& clip = gait_character()->clips[player.clip];
  const auto strike = [&](std::size_t i) { return to_seconds(clip.data_keys[i].time) / to_seconds(clip.duration); };
  const double at = phase(player);
  const bool between = strike(0) <= at && at < strike(1);
  const double way = between ? strike(1) - strike(0) : 1.0 - (strike(1) - strike(0));
  const double since = at - strike(between ? 0 : 1);
  return {.next = gait_character()->data_key_names[clip.data_keys[between ? 1 : 0].name],
          .gone = (since < 0.0 ? since + 1.0 : since) / way};
}

TEST(IdleOfABlendSpace, KeepsItsOwnRateBesideAWalk) {
  for (const float speed : {0.0F, 0.014F, 0.1F, 0.7F, 1.39F}) {
    Walker walker(speed);
    walker.step();
    EXPECT_EQ(rate(walker.player_of(gaits::idle)), 1.0) << speed;
    if (speed == 0.0F) continue;
    EXPECT_NEAR(rate(walker.player_of(gaits::walk)), 1.0, 1e-4) << "it takes shorter steps";
  }
}

TEST(IdleOfABlendSpace, BreathesOnWhileTheWalkComesAndGoes) {
  Walker walker(0.0F);
  for (int frame = 0; frame < 400; ++frame) {
    walker.set_speed(frame / 50 % 2 == 0 ? 0.0F : 0.02F * static_cast<float>(frame % 50));
    walker.step();
    const Ticks length = gait_character()->clips[gaits::idle].duration;
    ASSERT_EQ(walker.player_of(gaits::idle)->position / fine_ticks_per_tick, walker.system->clock() % length) << frame;
  }
}

TEST(IdleOfABlendSpace, IsToldByItsClipWhereTheParameterIsNoSpeed) {
  Walker walker(0.5F, {{.clip = gaits::idle, .parameter = 0.0F}, {.clip = gaits::walk, .parameter = 1.0F}}, false);
  walker.step();
  EXPECT_EQ(rate(walker.player_of(gaits::idle)), 1.0);
  EXPECT_NEAR(rate(walker.player_of(gaits::walk)), 1.0, 1e-4);
}

TEST(Pace, OfAPointMayBeSaid) {
  Walker walker(0.7F, {{.clip = gaits::idle, .parameter = 0.0F, .pace = Pace::gait},
                       {.clip = gaits::walk, .parameter = 1.4F, .pace = Pace::gait}});
  walker.step(to_ticks(0.25));
  EXPECT_NEAR(phase(*walker.player_of(gaits::idle)), phase(*walker.player_of(gaits::walk)), 1e-3);
}

TEST(BlendSpaceRoot, MovesAtTheParameterOverAnyInterval) {
  for (const float speed : {0.01F, 0.7F, 1.4F, 1.9F, 2.4F, 3.3F, 5.0F}) {
    Walker walker(speed);
    std::mt19937 random(11);
    for (int i = 0; i < 60; ++i) {
      const Ticks before = walker.system->clock();
      walker.system->advance(to_ticks(0.001 * static_cast<double>(1 + random() % 700)));
      const RootMotion moved =
          std::as_const(*walker.system).agent(0).motion().displacement(before, walker.system->clock());
      const double seconds = to_seconds(walker.system->clock() - before);
      ASSERT_NEAR(moved.translation.z, static_cast<double>(speed) * seconds, 2e-4 * seconds) << speed;
      if (i % 3 == 0) walker.step(Ticks{});
    }
  }
}

TEST(BlendSpaceFeet, ComeDownTogetherThoughTheirClipsStrikeAtOtherPhases) {
  for (const float speed : {1.5F, 1.9F, 2.5F, 2.7F, 3.4F, 4.1F}) {
    Walker walker(speed);
    double farthest = 0.0;
    for (int frame = 0; frame < 900; ++frame) {
      walker.step();
      const std::vector<const Player*> players = walker.players();
      ASSERT_EQ(players.size(), 2U);
      const StepPlace a = step_place(*players[0]), b = step_place(*players[1]);
      ASSERT_EQ(a.next, b.next) << speed << " at frame " << frame;
      farthest = std::max(farthest, std::abs(a.gone - b.gone));
    }
    EXPECT_LT(farthest, 1e-3) << speed;
  }
}

TEST(BlendSpaceFeet, GoByThePhaseWhereTheirStrikesAreUnlike) {
  Walker walker(2.2F, {{.clip = gaits::walk, .parameter = 1.4F}, {.clip = gaits::gallop, .parameter = 3.0F}});
  for (int frame = 0; frame < 200; ++frame) {
    walker.step();
    const std::vector<const Player*> players = walker.players();
    ASSERT_NEAR(std::remainder(phase(*players[0]) - phase(*players[1]), 1.0), 0.0, 1e-4);
  }
}

TEST(BlendSpaceSteps, ArriveOnceEachWithTheWeightOfBothGaits) {
  Walker walker(1.9F);
  std::vector<DataKeyEvent> steps;
  for (int frame = 0; frame < 1200; ++frame) {
    const std::vector<DataKeyEvent> met = walker.keys(walker.step());
    steps.insert(steps.end(), met.begin(), met.end());
  }
  ASSERT_GT(steps.size(), 30U);
  for (const DataKeyEvent& step : steps) EXPECT_EQ(step.weight, 1.0F);
  for (std::size_t i = 1; i < steps.size(); ++i) EXPECT_NE(steps[i].name, steps[i - 1].name) << "feet take turns";
}

TEST(BlendSpaceSteps, TakeTurnsWhileTheSpeedWanders) {
  Walker walker(1.0F);
  std::mt19937 random(3);
  float speed = 1.0F;
  std::vector<DataKeyEvent> steps;
  for (int frame = 0; frame < 6000; ++frame) {
    if (frame % 9 == 0)
      walker.set_speed(speed = std::clamp(speed + 0.1F * static_cast<float>(random() % 7) - 0.3F, 0.3F, 4.5F));
    for (const DataKeyEvent& event : walker.keys(walker.step())) {
      if (walker.name(event) != "breathe") steps.push_back(event);
    }
  }
  ASSERT_GT(steps.size(), 150U);
  for (std::size_t i = 1; i < steps.size(); ++i) ASSERT_NE(steps[i].name, steps[i - 1].name) << i;
}

TEST(BlendSpaceSteps, OfIdleBesideTheWalkKeepTheirOwnWeight) {
  Walker walker(0.7F);
  for (int frame = 0; frame < 200; ++frame) {
    for (const DataKeyEvent& event : walker.keys(walker.step())) EXPECT_NEAR(event.weight, 0.5F, 1e-5F);
  }
}

TEST(BlendSpaceSteps, OfTheHeaviestClipAloneMayBeAskedFor) {
  Walker walker(0.5F);
  int breaths = 0, steps = 0;
  for (int frame = 0; frame < 400; ++frame) {
    for (const DataKeyEvent& event : walker.keys(walker.step(), KeyChoice::heaviest)) {
      ++(walker.name(event) == "breathe" ? breaths : steps);
    }
  }
  EXPECT_GT(breaths, 5);
  EXPECT_EQ(steps, 0);
}

TEST(BlendSpaceGaits, AreWhereTheyAreWhoeverWasPosedInBetween) {
  Walker often(1.9F), seldom(1.9F);
  for (int i = 0; i < 100; ++i) {
    for (int frame = 0; frame < 7; ++frame) often.step();
    seldom.step(7 * (ticks_per_second / 60));
    for (std::size_t k = 0; k < 2; ++k) {
      ASSERT_NEAR(phase(*often.players()[k]), phase(*seldom.players()[k]), 1e-4) << i;
    }
  }
}

TEST(BlendSpaceGaits, DoNotMindAParameterThatIsNoNumber) {
  Walker walker(1.9F);
  const HeardMisuses heard;
  walker.set_speed(std::numeric_limits<float>::quiet_NaN());
  walker.step();
  EXPECT_EQ(std::as_const(*walker.system).agent(0).channel<BlendSpaceChannel>({0})->parameter(), 1.9F);
  EXPECT_EQ(HeardMisuses::all().size(), 1U);
}

}  // namespace
}  // namespace throng::anim::gaits_in_step_test
