// Placed feet on flat ground: the body keeps the height of its clips through every change of clips.

#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/agent/blend_space_channel.h"
#include "tests/assets/clip_list.h"
#include "tests/assets/paired_walkers.h"

namespace throng::test::mannequin_feet_test {
namespace {

constexpr float two_centimetres = 0.02F;
constexpr int idle = 0;
constexpr int walk = 1;
constexpr int jog = 5;
constexpr int run = 6;
static_assert(clip_list[walk] == std::string_view("walk") && clip_list[jog] == std::string_view("jog"));

/// A request in a frame.
struct Ask {
  int frame;
  anim::PlayRequest request;
};
using Plan = std::vector<Ask>;

class MannequinFeet : public testing::Test {
 protected:
  double between(double from, double to) {
    return from + (to - from) * (static_cast<double>(random_()) / 4294967296.0);
  }

  anim::PlayRequest some_clip(double least_fade, double most_fade) {
    return some_of(static_cast<int>(random_() % clip_list.size()), least_fade, most_fade);
  }
  anim::PlayRequest some_of(int clip, double least_fade, double most_fade) {
    const double seconds = to_seconds(PairedWalkers::character().clips[static_cast<std::size_t>(clip)].duration);
    return {.clip = clip,
            .fade = to_ticks(between(least_fade, most_fade)),
            .start = to_ticks(between(0.0, 0.99) * seconds),
            .loop = !plays_once(clip_list[static_cast<std::size_t>(clip)])};
  }
  int some_gait() { return std::array{idle, walk, jog, run}[random_() % 4U]; }
  int some_frame() { return static_cast<int>(between(30.0, 75.0)); }

  /// Plays a plan in each pair.
  static WalkFigures play(const std::vector<Plan>& plans, int frames = 150) {
    PairedWalkers walkers(plans.size());
    WalkFigures figures;
    std::vector<PairedWalkers::Pair> before;
    for (int frame = 0; frame < frames; ++frame) {
      for (std::size_t pair = 0; pair < plans.size(); ++pair) {
        for (const Ask& ask : plans[pair]) {
          if (ask.frame == frame) walkers.play(pair, ask.request);
        }
      }
      const std::vector<PairedWalkers::Pair>& now = walkers.step();
      if (before.empty()) before = now;
      for (std::size_t pair = 0; pair < plans.size(); ++pair) figures.add(before[pair], now[pair]);
      before = now;
    }
    return figures;
  }

  std::mt19937 random_{2206};
};

TEST_F(MannequinFeet, KeepTheHipsWithinTwoCentimetresOfTheClipsThroughRandomFades) {
  std::vector<Plan> plans(300);
  for (Plan& plan : plans) plan = {{0, some_clip(0.0, 0.0)}, {some_frame(), some_clip(0.1, 0.6)}};
  EXPECT_LT(play(plans).most_drop, two_centimetres);
}

TEST_F(MannequinFeet, KeepTheHipsWithinTwoCentimetresThroughFadesThatAreInterrupted) {
  std::vector<Plan> plans(150);
  for (Plan& plan : plans) {
    const int frame = some_frame();
    plan = {{0, some_clip(0.0, 0.0)},
            {frame, some_clip(0.3, 0.6)},
            {frame + static_cast<int>(between(3.0, 15.0)), some_clip(0.1, 0.5)}};
  }
  EXPECT_LT(play(plans).most_drop, two_centimetres);
}

TEST_F(MannequinFeet, KeepTheHipsWithinTwoCentimetresFromIdleToWalkAndBackWhereverTheFeetAre) {
  std::vector<Plan> plans(100);
  for (Plan& plan : plans) {
    plan = {{0, some_of(idle, 0.0, 0.0)}, {20, some_of(walk, 0.2, 1.0)}, {some_frame() + 70, some_of(idle, 0.2, 1.0)}};
  }
  EXPECT_LT(play(plans, 240).most_drop, two_centimetres);
}

TEST_F(MannequinFeet, KeepTheHipsWithinTwoCentimetresInABlendSpace) {
  constexpr std::size_t pairs = 60;
  PairedWalkers walkers(pairs);
  WalkFigures figures;
  std::vector<anim::BlendPoint> gaits{{idle, 0.0F}};
  for (const int clip : {walk, jog, run}) {
    gaits.push_back(
        {clip, static_cast<float>(PairedWalkers::character().clips[static_cast<std::size_t>(clip)].ground_speed())});
  }
  std::vector<float> speeds(pairs);
  for (std::size_t pair = 0; pair < pairs; ++pair) {
    walkers.ask(pair, [&](anim::Agent agent) {
      EXPECT_TRUE(agent.add_channel(std::make_unique<anim::BlendSpaceChannel>(gaits, 0.0F, true)));
    });
  }
  std::vector<float> wanted(pairs, 0.0F);
  std::vector<PairedWalkers::Pair> before = walkers.step();
  for (int frame = 0; frame < 300; ++frame) {
    for (std::size_t pair = 0; pair < pairs; ++pair) {
      if (random_() % 60U == 0) wanted[pair] = static_cast<float>(between(0.0, 1.0)) * gaits.back().parameter;
      speeds[pair] += 0.08F * (wanted[pair] - speeds[pair]);
      walkers.ask(pair, [&](anim::Agent agent) {
        EXPECT_TRUE(agent.change<anim::BlendSpaceChannel>({0}, [&](auto& walk) { walk.set_parameter(speeds[pair]); }));
      });
    }
    const std::vector<PairedWalkers::Pair>& now = walkers.step();
    for (std::size_t pair = 0; pair < pairs; ++pair) figures.add(before[pair], now[pair]);
    before = now;
  }
  EXPECT_LT(figures.most_drop, two_centimetres);
}

TEST_F(MannequinFeet, SlideLessThanAQuarterAsFarAsTheClipsBetweenGaits) {
  std::vector<Plan> plans(200);
  for (Plan& plan : plans) {
    plan = {{0, some_of(some_gait(), 0.0, 0.0)}, {some_frame(), some_of(some_gait(), 0.2, 0.6)}};
  }
  const WalkFigures figures = play(plans);
  EXPECT_GT(figures.slid_in_clip, 20.0) << "metres, of 200 fades";
  EXPECT_LT(figures.slid, 0.25 * figures.slid_in_clip);
}

TEST_F(MannequinFeet, ComeBackToTheClipWithoutAPop) {
  std::vector<Plan> plans(200);
  for (Plan& plan : plans) {
    plan = {{0, some_of(some_gait(), 0.0, 0.0)}, {some_frame(), some_of(some_gait(), 0.2, 0.6)}};
  }
  EXPECT_LT(play(plans).most_extra_step, 0.07F) << "metres in a sixtieth of a second; a foot of a runner makes 0.14";
}

}  // namespace
}  // namespace throng::test::mannequin_feet_test
