// Data keys of layers, and the ends of clips that do not loop.

#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/agent/simple_channel.h"
#include "engine/anim/asset/bone_mask.h"
#include "tests/anim/agent/gait_crowd.h"

namespace throng::anim::data_key_events_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;

std::vector<float> weights_of_hits(GaitCrowd& crowd, KeyChoice choice = KeyChoice::felt) {
  std::vector<float> weights;
  for (int i = 0; i < 40; ++i) {
    for (const DataKeyEvent& event : crowd.keys(crowd.step(), choice)) {
      if (crowd.name(event) == "hit") weights.push_back(event.weight);
    }
  }
  return weights;
}

/// Lays a wave over a walk, on the second bone and all above it.
GaitCrowd waving(float weight, float mask_weight) {
  GaitCrowd crowd;
  const SubtreeWeight chest{.bone = 1, .weight = mask_weight};
  const int mask = crowd.system->characters().add_mask(BoneMask("chest", gait_character()->skeleton, {&chest, 1}));
  crowd.system->agent(0).play({.clip = gaits::walk});
  const Status added = crowd.system->agent(0).add_channel(
      std::make_unique<SimpleChannel>(PlayerStart{.clip = gaits::wave}), {.weight = weight, .mask = mask});
  EXPECT_TRUE(added) << added.error().message;
  return crowd;
}

TEST(DataKeyEvent, OfAMaskedLayerWeighsWhatItHasWhereItHasMost) {
  GaitCrowd whole = waving(1.0F, 1.0F);
  EXPECT_EQ(weights_of_hits(whole), std::vector<float>{1.0F});
  GaitCrowd half = waving(0.5F, 1.0F);
  EXPECT_EQ(weights_of_hits(half), std::vector<float>{0.5F});
  GaitCrowd light = waving(0.5F, 0.5F);
  EXPECT_EQ(weights_of_hits(light), std::vector<float>{0.25F});
}

TEST(DataKeyEvent, OfWhatLiesUnderAMaskWeighsWhatTheMaskLeavesItSomewhere) {
  GaitCrowd crowd = waving(1.0F, 1.0F);
  int steps = 0;
  for (int i = 0; i < 60; ++i) {
    for (const DataKeyEvent& event : crowd.keys(crowd.step())) {
      if (crowd.name(event) == "hit") continue;
      ++steps;
      EXPECT_EQ(event.weight, 1.0F) << "nothing covers the hips";
    }
  }
  EXPECT_GE(steps, 2);
}

TEST(DataKeyEvent, OfALayerWithoutWeightIsNotFelt) {
  GaitCrowd crowd = waving(0.0F, 1.0F);
  EXPECT_TRUE(weights_of_hits(crowd).empty());
}

TEST(DataKeyEvent, OfALayerWithoutWeightComesWhereAllAreAskedFor) {
  GaitCrowd crowd = waving(0.0F, 1.0F);
  EXPECT_EQ(weights_of_hits(crowd, KeyChoice::all), std::vector<float>{0.0F});
}

struct Ends {
  std::vector<ClipEnd> ends;
  void ask(const GaitCrowd& crowd, Ticks from) {
    const AgentMotion motion = std::as_const(*crowd.system).agent(0).motion();
    motion.for_each_end(from, crowd.system->clock(), [&](const ClipEnd& end) { ends.push_back(end); });
  }
};

Ticks wave_length() { return gait_character()->clips[gaits::wave].duration; }

TEST(ClipEnd, ComesOnceInTheIntervalInWhichTheClipArrives) {
  GaitCrowd crowd;
  crowd->agent(0).play({.clip = gaits::wave, .loop = false});
  for (int i = 0; i < 200; ++i) {
    Ends now;
    const Ticks before = crowd.step();
    now.ask(crowd, before);
    const bool arrives = before < wave_length() && wave_length() <= crowd->clock();
    ASSERT_EQ(now.ends.size(), arrives ? 1U : 0U) << i;
    if (!arrives) continue;
    EXPECT_EQ(now.ends[0].time, wave_length());
    EXPECT_EQ(now.ends[0].clip, static_cast<std::uint32_t>(gaits::wave));
    EXPECT_EQ(now.ends[0].weight, 1.0F);
  }
}

TEST(ClipEnd, ComesOnceWhereTheAgentIsPosedSeldomAndAheadOfTheClock) {
  for (const int every : {1, 3, 8, 50}) {
    GaitCrowd crowd;
    crowd->agent(0).play({.clip = gaits::wave, .loop = false});
    Ends met;
    for (int i = 0; i < 200; ++i) {
      const Ticks before = crowd->clock();
      crowd->advance(frame);
      met.ask(crowd, before);
      const PoseRequest update{.agent = {0}, .look_ahead = (every - 1) * frame};
      if (i % every == 0) crowd->update({&update, 1});
    }
    ASSERT_EQ(met.ends.size(), 1U) << every;
    EXPECT_EQ(met.ends[0].time, wave_length()) << every;
  }
}

TEST(ClipEnd, ComesAtTheStartWhereTheClipPlaysBackwards) {
  GaitCrowd crowd;
  crowd->agent(0).play({.clip = gaits::wave, .speed = -2.0, .start = wave_length(), .loop = false});
  Ends met;
  for (int i = 0; i < 100; ++i) {
    const Ticks before = crowd.step();
    met.ask(crowd, before);
  }
  ASSERT_EQ(met.ends.size(), 1U);
  EXPECT_EQ(met.ends[0].time, (wave_length() + Ticks{1}) / 2);
}

TEST(ClipEnd, ComesAgainWhereTheClipIsPlayedBack) {
  GaitCrowd crowd;
  crowd->agent(0).play({.clip = gaits::wave, .loop = false});
  Ends met;
  for (int i = 0; i < 300; ++i) {
    if (i == 150) crowd->agent(0).set_speed(-1.0);
    const Ticks before = crowd.step();
    met.ask(crowd, before);
  }
  ASSERT_EQ(met.ends.size(), 2U);
  EXPECT_EQ(met.ends[1].time, 150 * frame + wave_length()) << "it goes back from the end that it held";
}

TEST(ClipEnd, NeverComesOfALoop) {
  GaitCrowd crowd;
  crowd->agent(0).play({.clip = gaits::wave});
  Ends met;
  crowd->advance(10 * wave_length());
  met.ask(crowd, Ticks{});
  EXPECT_TRUE(met.ends.empty());
}

}  // namespace
}  // namespace throng::anim::data_key_events_test
