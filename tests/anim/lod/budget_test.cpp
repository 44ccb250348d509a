// The rule by budget: whatever is cheapest whose predicted error on screen is within the tolerance.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/lod/lod.h"
#include "engine/anim/lod/lod_choices.h"
#include "engine/anim/run/pu_threads.h"

namespace throng::anim::budget_test {
namespace {

constexpr float pixels_per_unit = 800.0F;
constexpr std::array<SkipError, 1> walk{};

// A crowd seen by a camera at the origin that looks along -Z and sees everything before it.
struct LodBudgetTest : testing::Test {
  std::vector<glm::vec3> positions;
  std::vector<float> scales, importance;
  LodCharacter character{.centre_height = 0.0F,
                         .radius = 1.0F,
                         .level_error_metres = {0.0F, 0.002F, 0.01F, 0.05F},
                         .update_nanoseconds = {1600, 1200, 800, 400},
                         .clips = walk};
  LodChoices choices;
  LodFrame frame;
  LodState state;
  LodSelection selection;

  LodBudgetTest() {
    frame.camera.frustum.fill({0.0F, 0.0F, -1.0F, 0.0F});
    frame.camera.pixels_per_unit = pixels_per_unit;
    frame.rules = {.rule = LodRule::budget, .smooth = true, .centre_importance = 1.0F};
    frame.counts_cost = true;
    frame.number = 100;
  }

  /// One every metre, straight ahead.
  void spawn(std::size_t agents) {
    positions.clear();
    for (std::size_t i = 0; i < agents; ++i) positions.push_back({0.0F, 0.0F, -1.0F - static_cast<float>(i)});
    scales.assign(agents, 1.0F);
    importance.assign(agents, 1.0F);
    state.resize(agents, selection);
  }

  void select_next() {
    ++frame.number;
    frame.characters = {&character, 1};
    frame.positions = positions;
    frame.scales = scales;
    frame.importance = importance;
    frame.choices = &choices;
    choices.build(frame.characters, frame.rules, 1.0F / 60.0F);
    select_for_update(frame, state, selection);
  }

  /// Pixels that the agent is predicted to be off, drawn at a distance of so many metres.
  float error_on_screen(const VisibleAgent& agent, float metres) const {
    return choices.of(0, 0).error_metres({agent.interval, agent.bone_level}) * pixels_per_unit / metres;
  }
};

TEST_F(LodBudgetTest, NobodyIsPredictedToBeOffByMoreThanTheTolerance) {
  spawn(200);
  for (const float tolerance : {0.25F, 1.0F, 4.0F}) {
    frame.tolerance_pixels = tolerance;
    for (int i = 0; i < 20; ++i) select_next();
    for (const VisibleAgent& agent : selection.visible) {
      EXPECT_LE(error_on_screen(agent, 1.0F + static_cast<float>(agent.agent)), tolerance * 1.001F) << agent.agent;
    }
  }
}

TEST_F(LodBudgetTest, TheFartherAndTheSmallerTheCheaper) {
  spawn(200);
  select_next();
  const MotionLod& motion = choices.of(0, 0);
  const auto cost = [&](std::size_t agent) {
    return motion.cost({selection.visible[agent].interval, selection.visible[agent].bone_level});
  };
  for (std::size_t agent = 1; agent < positions.size(); ++agent) EXPECT_LE(cost(agent), cost(agent - 1));
  EXPECT_LT(cost(199), cost(0) / 8.0F);
}

TEST_F(LodBudgetTest, TwiceTheImportanceIsHalfTheDistance) {
  spawn(100);
  select_next();
  const std::vector<VisibleAgent> usual(selection.visible.begin(), selection.visible.end());
  spawn(100);
  std::ranges::fill(importance, 2.0F);
  for (glm::vec3& position : positions) position *= 2.0F;
  select_next();
  for (std::size_t agent = 0; agent < usual.size(); ++agent) {
    EXPECT_EQ(selection.visible[agent].interval, usual[agent].interval);
    EXPECT_EQ(selection.visible[agent].bone_level, usual[agent].bone_level);
  }
}

TEST_F(LodBudgetTest, TheMiddleOfThePictureMattersMore) {
  spawn(1);
  positions[0] = {0.0F, 0.0F, -25.0F};
  select_next();
  const float usual = error_on_screen(selection.visible[0], 25.0F);
  frame.rules.centre_importance = 4.0F;
  state.make_all_due();
  select_next();
  EXPECT_LT(error_on_screen(selection.visible[0], 25.0F), usual);
  EXPECT_LE(error_on_screen(selection.visible[0], 25.0F), 0.25F * 1.001F);
}

TEST_F(LodBudgetTest, WhoeverGoesToAndFroKeepsWhatItHas) {
  spawn(1);
  int changes = 0;
  std::uint8_t level = 0;
  for (int i = 0; i < 200; ++i) {
    positions[0].z = i % 2 == 0 ? -40.0F : -41.0F;
    select_next();
    if (i > 20 && selection.visible[0].bone_level != level) ++changes;
    level = selection.visible[0].bone_level;
  }
  EXPECT_EQ(changes, 0);
}

TEST_F(LodBudgetTest, TheHistogramSaysWhatTheCrowdCostsInTheLongRun) {
  spawn(500);
  frame.tolerance_pixels = 1.0F;
  for (int i = 0; i < 50; ++i) select_next();
  std::uint64_t spent = 0;
  constexpr int frames = 240;
  for (int i = 0; i < frames; ++i) {
    select_next();
    spent += selection.cost.due;
  }
  const auto step = static_cast<std::size_t>(step_of_tolerance(1.0F));
  const auto predicted = static_cast<double>(selection.cost.by_tolerance[step]);
  EXPECT_NEAR(static_cast<double>(spent) / frames, predicted, 0.1 * predicted);
  EXPECT_TRUE(std::ranges::is_sorted(selection.cost.by_tolerance, std::greater{}));
}

TEST_F(LodBudgetTest, CostsAreOfEveryoneOfTheVisibleAndOfThoseWhoAreDue) {
  spawn(10);
  positions[3].z = 5.0F;  // behind the camera
  select_next();
  EXPECT_EQ(selection.cost.everyone, 16'000U);
  EXPECT_EQ(selection.cost.visible, 14'400U);
  EXPECT_EQ(selection.cost.due_all_bones, 14'400U);
  EXPECT_EQ(selection.cost.due, selection.cost.reappeared) << "all came into view";
  select_next();
  EXPECT_EQ(selection.cost.due, selection.cost.reappeared) << "and look ahead from there";
  select_next();
  EXPECT_EQ(selection.cost.reappeared, 0U);
}

TEST_F(LodBudgetTest, CostsDoNotDependOnHowTheWorkIsShared) {
  spawn(3000);
  select_next();
  const LodCost alone = selection.cost;
  PuThreads threads(3);
  state.make_all_due();
  select_for_update(frame, state, selection, threads, 3);
  EXPECT_EQ(selection.cost.by_tolerance, alone.by_tolerance);
  EXPECT_EQ(selection.cost.due, alone.due);
}

}  // namespace
}  // namespace throng::anim::budget_test
