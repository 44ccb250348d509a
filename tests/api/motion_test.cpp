// What an agent's motion tells.

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/anim/agent/heard_misuses.h"
#include "tests/api/api_crowd.h"

namespace throng::motion_test {
namespace {

using anim::HeardMisuses;
using api_test::ApiCrowd;
using api_test::mannequin;

TEST(ApiMotion, OfABlendSpaceMovesAtItsParameter) {
  ApiCrowd crowd(1);
  const ClipId walk = mannequin().find_clip("walk");
  const auto speed = static_cast<float>(mannequin().clip(walk).ground_speed);
  const BlendPoint points[] = {{.clip = mannequin().find_clip("idle")}, {.clip = walk, .parameter = speed}};
  const auto gaits = crowd.agent(0).add(BlendSpace{.points = points});
  ASSERT_TRUE(gaits);
  EXPECT_TRUE(crowd.agent(0).set_parameter(*gaits, 0.5F * speed));
  crowd.step(60);
  const Ticks before = crowd->clock();
  crowd.step(60);
  const RootMotion moved = crowd.agent(0).motion().displacement(before, crowd->clock());
  EXPECT_NEAR(moved.displacement.z, 0.5F * speed, 0.02F);
}

TEST(ApiMotion, OfAClipThatLoopsForTenYearsIsThatOfTheFirstSecond) {
  ApiCrowd crowd(1);
  crowd.agent(0).play({.clip = mannequin().find_clip("walk")});
  crowd.step();
  const auto second = [&] {
    const Ticks before = crowd->clock();
    crowd.step(60);
    int keys = 0;
    crowd.agent(0).motion().for_each_key(before, crowd->clock(), [&](const DataKey&) { ++keys; });
    return std::pair(crowd.agent(0).motion().displacement(before, crowd->clock()).displacement.z, keys);
  };
  const auto [moved, keys] = second();
  // Whole loops a day, so that the feet stand where they stood.
  const Ticks loop = mannequin().clip(mannequin().find_clip("walk")).duration;
  const Ticks day = 24 * 3600 * ticks_per_second / loop * loop;
  crowd->advance(loop - 60 * (ticks_per_second / 60) % loop);
  for (int number = 0; number < 3650; ++number) {
    crowd->advance(day - ticks_per_second / 60);
    crowd.step();
  }
  const auto [later, later_keys] = second();
  EXPECT_NEAR(later, moved, 1e-4F);
  EXPECT_EQ(later_keys, keys);
}

TEST(ApiMotion, TellsEachKeyOnceAndWhenAClipEnds) {
  ApiCrowd crowd(1);
  crowd.agent(0).play({.clip = mannequin().find_clip("walk")});
  const double seconds = to_seconds(mannequin().clip(mannequin().find_clip("walk")).duration);
  int steps = 0, ends = 0;
  for (int frame = 0; frame < 600; ++frame) {
    const Ticks before = crowd->clock();
    crowd->advance(ticks_per_second / 60);
    crowd.agent(0).motion().for_each_key(before, crowd->clock(), [&](const DataKey&) { ++steps; });
  }
  EXPECT_NEAR(steps, 2.0 * 10.0 / seconds, 2.0);
  crowd.agent(0).play({.clip = mannequin().find_clip("wave"), .loop = false});
  for (int frame = 0; frame < 600; ++frame) {
    const Ticks before = crowd->clock();
    crowd->advance(ticks_per_second / 60);
    crowd.agent(0).motion().for_each_end(before, crowd->clock(), [&](const ClipEnd&) { ++ends; });
  }
  EXPECT_EQ(ends, 1);
}

TEST(ApiMotion, TellsAListenerThatChangesTheCrowdWhatWasMet) {
  ApiCrowd crowd(3);
  for (std::uint32_t agent = 0; agent < 3; ++agent) crowd.agent(agent).play({.clip = mannequin().find_clip("walk")});
  crowd->advance(20 * ticks_per_second);  // more keys than a frame ever meets
  std::vector<Ticks> met, met_by_another;
  crowd.agent(1).motion().for_each_key({}, crowd->clock(),
                                       [&](const DataKey& key) { met_by_another.push_back(key.time); });
  crowd.agent(0).motion().for_each_key({}, crowd->clock(), [&](const DataKey& key) {
    met.push_back(key.time);
    crowd->add_agents(500);
    crowd->remove_agent({0});
  });
  EXPECT_GT(met.size(), 20U);
  EXPECT_EQ(met, met_by_another);
  const Crowd gone = [&] {
    std::optional<Crowd> taken;
    crowd.agent(2).motion().for_each_key({}, crowd->clock(), [&](const DataKey&) {
      if (!taken) taken = std::move(*crowd);
    });
    return std::move(*taken);
  }();
  EXPECT_GT(gone.number_limit(), 500U);
}

TEST(ApiMotion, OfAnIntervalThatEndsBeforeItBeginsMeetsNothing) {
  const HeardMisuses heard;
  ApiCrowd crowd(1);
  crowd.agent(0).play({.clip = mannequin().find_clip("walk")});
  crowd->advance(2 * ticks_per_second);
  int met = 0;
  crowd.agent(0).motion().for_each_key(crowd->clock(), {}, [&](const DataKey&) { ++met; });
  EXPECT_EQ(met, 0);
  EXPECT_EQ(HeardMisuses::all().size(), 1U);
}

}  // namespace
}  // namespace throng::motion_test
