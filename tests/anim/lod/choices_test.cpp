#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <gtest/gtest.h>

#include "engine/anim/lod/lod_choices.h"

namespace throng::anim::choices_test {
namespace {

/// Four levels that are off by a millimetre, a centimetre and a decimetre, of a person who walks.
LodCharacter person() {
  return {.level_error_metres = {0.0F, 0.001F, 0.01F, 0.1F}, .update_nanoseconds = {1600, 1200, 800, 400}};
}

struct LodChoicesTest : testing::Test {
  LodCharacter character = person();
  LodRules rules{.rule = LodRule::budget, .largest_interval = 8, .smooth = true};
  float frame_seconds = 1.0F / 60.0F;

  MotionLod motion(const SkipError& clip = {}) const { return MotionLod(character, clip, rules, frame_seconds); }
};

TEST(AllowanceStep, IsTheWholePartOfALogarithm) {
  for (float metres = least_allowance_metres; metres < 40.0F; metres *= 1.0007F) {
    const float exact = steps_an_octave * std::log2(metres / least_allowance_metres);
    ASSERT_EQ(allowance_step(metres), std::min(static_cast<int>(exact), allowance_steps)) << metres << " m";
  }
  EXPECT_EQ(allowance_step(std::nextafter(least_allowance_metres, 0.0F)), -1);
  EXPECT_EQ(allowance_step(std::numeric_limits<float>::infinity()), allowance_steps);
  EXPECT_EQ(allowance_step(std::numeric_limits<float>::quiet_NaN()), -1);
}

TEST_F(LodChoicesTest, WhoMayNotBeOffIsUpdatedEachFrameWithAllBones) {
  EXPECT_EQ(motion().choose(0.0F), LodChoice{});
  EXPECT_EQ(motion().choose(1e-5F), LodChoice{});
}

TEST_F(LodChoicesTest, EveryChoiceIsWithinWhatIsAllowed) {
  const MotionLod walk = motion();
  for (float allowed = 1e-4F; allowed < 1.0F; allowed *= 1.01F) {
    EXPECT_LE(walk.error_metres(walk.choose(allowed)), allowed);
  }
}

TEST_F(LodChoicesTest, NoPairWithinWhatIsAllowedIsCheaper) {
  const MotionLod walk = motion();
  for (float allowed = 1e-4F; allowed < 1.0F; allowed *= 1.3F) {
    const LodChoice chosen = walk.choose(allowed);
    for (std::uint8_t level = 0; level < max_bone_levels; ++level) {
      for (std::uint8_t interval = 1; interval <= rules.largest_interval; ++interval) {
        const LodChoice other{interval, level};
        const bool within = walk.error_metres(other) <= allowed * 0.9F;  // steps are an eighth of an octave apart
        EXPECT_FALSE(within && walk.cost(other) < walk.cost(chosen)) << allowed;
      }
    }
  }
}

TEST_F(LodChoicesTest, WhatStandsStillIsUpdatedAsRarelyAsMayBe) {
  EXPECT_EQ(motion(no_skip_error).choose(1e-4F), (LodChoice{8, 0}));
  rules.largest_interval = 4;
  EXPECT_EQ(motion(no_skip_error).choose(1e-4F), (LodChoice{4, 0}));
}

TEST_F(LodChoicesTest, WithoutBoneLodAllBonesStay) {
  rules.bone_lod = false;
  EXPECT_EQ(motion().choose(1.0F).bone_level, 0);
}

TEST_F(LodChoicesTest, LongerFramesSkipLess) {
  const int at_sixty = motion().choose(0.01F, {}).interval;
  frame_seconds = 1.0F / 15.0F;
  EXPECT_LT(motion().choose(0.01F, {}).interval, at_sixty);
}

TEST_F(LodChoicesTest, HoldingPosesSkipsLessThanBlendingThem) {
  const int blending = motion().choose(0.02F).interval;
  rules.smooth = false;
  EXPECT_LT(motion().choose(0.02F).interval, blending);
}

TEST_F(LodChoicesTest, AChoiceStaysUntilACheaperOneIsWellWithin) {
  const MotionLod walk = motion();
  const float errors = walk.error_metres({8, 1});
  const LodChoice finer = walk.choose(errors * 0.95F);
  ASSERT_NE(finer, (LodChoice{8, 1}));
  EXPECT_EQ(walk.choose(errors * 1.05F, finer), finer) << "not yet";
  EXPECT_EQ(walk.choose(errors * 1.3F, finer), walk.choose(errors * 1.3F * 0.9F));
}

TEST_F(LodChoicesTest, AChoiceThatIsTooFarOffGoesAtOnce) {
  const MotionLod walk = motion();
  const LodChoice shown{8, 3};
  const float allowed = walk.error_metres(shown) * 0.99F;
  EXPECT_LE(walk.error_metres(walk.choose(allowed, shown)), allowed);
}

TEST_F(LodChoicesTest, TheHistogramCostsWhatTheChoicesDo) {
  const MotionLod walk = motion();
  constexpr float metres_a_pixel = 0.01F;
  std::array<std::uint32_t, tolerance_steps> cost{};
  walk.add_cost(metres_a_pixel, cost);
  for (int step = 0; step < tolerance_steps; ++step) {
    const float allowed = metres_a_pixel * tolerance_at(static_cast<float>(step));
    EXPECT_GE(static_cast<float>(cost[static_cast<std::size_t>(step)]) + 1.0F, walk.cost(walk.choose(allowed)));
    EXPECT_LE(static_cast<float>(cost[static_cast<std::size_t>(step)]), walk.cost(walk.choose(allowed * 0.9F)));
  }
}

TEST_F(LodChoicesTest, WhoHasAllBonesInEachFrameCostsItsPlacedFeetToo) {
  character.full_rate_nanoseconds = 800;
  EXPECT_EQ(motion().cost({1, 0}), 2400.0F);
  EXPECT_EQ(motion().cost({1, 1}), 1200.0F);
  EXPECT_EQ(motion().cost({2, 0}), 800.0F);
}

TEST_F(LodChoicesTest, EachClipHasAMotionOfItsOwnAndNoClipStandsStill) {
  const std::array<SkipError, 2> clips{no_skip_error, SkipError{}};
  character.clips = clips;
  LodChoices choices;
  choices.build({&character, 1}, rules, frame_seconds);
  EXPECT_EQ(choices.of(0, -1).choose(1e-3F).interval, 8);
  EXPECT_EQ(choices.of(0, 0).choose(1e-3F).interval, 8);
  EXPECT_LT(choices.of(0, 1).choose(1e-3F).interval, 8);
}

}  // namespace
}  // namespace throng::anim::choices_test
