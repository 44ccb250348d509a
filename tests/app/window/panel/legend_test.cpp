// The legend says in words what the colours in the picture mean.
#include "app/window/panel/legend.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/settings/agent_colors.h"
#include "app/settings/choices.h"
#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::legend_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Legends : testing::Test {
  std::vector<LegendPart> legend() const { return legend_of(report, tuning); }
  LegendPart legend_of_view(DebugView view) {
    tuning.debug_view = view;
    const std::vector<LegendPart> parts = legend();
    EXPECT_EQ(parts.size(), 1U);
    return parts.empty() ? LegendPart() : parts.front();
  }
  static std::vector<std::string> words_of(const LegendPart& part) {
    std::vector<std::string> words;
    for (const LegendStep& step : part.steps) words.push_back(step.words);
    return words;
  }

  FrameReport report = full_report();
  Tuning tuning;
};

/// All details that agents may have.
std::vector<AgentDetail> all_details(const Tuning& tuning) {
  std::vector<AgentDetail> details;
  for (int interval = 1; interval <= tuning.lod.largest_interval; ++interval) details.push_back({.interval = interval});
  for (int level = 0; level < 4; ++level) details.push_back({.bone_level = level});
  for (int lod = 0; lod < mesh_lod_steps; ++lod) details.push_back({.mesh_lod = lod});
  const float top = color_scale(tuning).value_or(ColorScale{}).top;
  for (const float share : {0.0F, 0.25F, 0.5F, 1.0F}) details.push_back({.measure = share * top});
  for (const float error : {0.0F, 0.2F, 0.3F, 0.7F, 1.5F, 3.0F, 9.0F}) details.push_back({.error_px = error});
  return details;
}

// It goes through all enumerators, so that a new way to colour the crowd without a legend fails.
TEST_F(Legends, HaveAllColoursThatAnyWayToColourGives) {
  for (std::size_t i = 0; i < debug_view_words.size(); ++i) {
    const auto view = static_cast<DebugView>(i);
    for (const int largest : {1, 4, 8, 16}) {
      tuning.lod.largest_interval = largest;
      tuning.debug_view = view;
      std::vector<std::uint32_t> explained;
      for (const LegendPart& part : legend()) {
        for (const LegendStep& step : part.steps) explained.push_back(step.color);
        if (part.ramp) explained.insert(explained.end(), part.ramp->colors.begin(), part.ramp->colors.end());
      }
      for (const AgentDetail& detail : all_details(tuning)) {
        const std::uint32_t color = debug_color(tuning, detail);
        EXPECT_TRUE(color == 0 || std::ranges::count(explained, color) == 1) << debug_view_words.at(i) << color;
      }
      EXPECT_EQ(explained.empty(), view == DebugView::none) << debug_view_words.at(i);
    }
  }
}

TEST_F(Legends, TellEightIntervalsApartAndSayWhichShareTheLastColour) {
  const LegendPart part = legend_of_view(DebugView::interval);
  EXPECT_THAT(words_of(part), ElementsAre("1 frame", "2 frames", "3 frames", "4 frames", "5 frames", "6 frames",
                                          "7 frames", "8 frames"));
  EXPECT_EQ(part.steps.front().agents, 300);
  EXPECT_EQ(part.steps[1].color, debug_color(tuning, {.interval = 2}));
  tuning.lod.largest_interval = 16;
  EXPECT_EQ(words_of(legend_of_view(DebugView::interval)).back(), "8 to 16 frames");
  tuning.lod.largest_interval = 3;
  EXPECT_THAT(words_of(legend_of_view(DebugView::interval)), ElementsAre("1 frame", "2 frames", "3 frames"));
  tuning.lod.rule = LodRule::off;
  EXPECT_THAT(words_of(legend_of_view(DebugView::interval)), ElementsAre("1 frame"));
}

TEST_F(Legends, SayWhichBonesALevelHasAndForHowMany) {
  const LegendPart part = legend_of_view(DebugView::bone_level);
  EXPECT_THAT(words_of(part),
              ElementsAre("level 0: 4 bones", "level 1: 3 bones", "level 2: 2 bones", "level 3: 1 bone"));
  EXPECT_EQ(part.steps[1].agents, 200);
  EXPECT_EQ(part.steps[3].color, debug_color(tuning, {.bone_level = 3}));
}

TEST_F(Legends, SayHowManyTrianglesAMeshHas) {
  report.situation.mesh_levels = 2;
  report.meshes.lods = {{.triangles = 5500, .agents = 3}, {.triangles = 640, .agents = 9}};
  const LegendPart part = legend_of_view(DebugView::mesh_lod);
  EXPECT_THAT(words_of(part), ElementsAre("LOD 0: 5,500 triangles", "LOD 1: 640 triangles"));
  EXPECT_EQ(part.steps[1].agents, 9);
}

TEST_F(Legends, SayThePixelsOfAnErrorAndWhoWasNotMeasured) {
  const LegendPart part = legend_of_view(DebugView::error);
  EXPECT_THAT(words_of(part), ElementsAre("below 0.25 px", "0.25 to 0.5 px", "0.5 to 1 px", "1 to 2 px", "2 to 4 px",
                                          "4 px or more", "not measured"));
  EXPECT_EQ(part.steps[2].color, debug_color(tuning, {.error_px = 0.6F}));
  EXPECT_EQ(part.steps.back().color, 0U);
  tuning.plain_bodies = true;
  EXPECT_EQ(legend_of_view(DebugView::error).steps.back().color, plain_body_color);
}

TEST_F(Legends, OfAMeasureAreABarWithTicksInUnits) {
  const auto ticks_of = [this](DebugView view) {
    std::string words;
    const LegendPart part = legend_of_view(view);
    for (const LegendTick& tick : part.ramp.value().ticks) words += tick.words + ' ';
    return words;
  };
  EXPECT_EQ(legend_of_view(DebugView::speed).title, "Speed, m/s");
  EXPECT_EQ(ticks_of(DebugView::speed), "0 0.5 1 1.5 2+ ");
  EXPECT_EQ(legend_of_view(DebugView::density).title, "Density, 1/m\xC2\xB2");
  EXPECT_EQ(ticks_of(DebugView::density), "0 1 2 3 4 5+ ");
  EXPECT_EQ(legend_of_view(DebugView::presence).title, "Here for, s");
  EXPECT_EQ(ticks_of(DebugView::presence), "0 20 40 60+ ");
  tuning.top_presence = 600.0F;
  EXPECT_EQ(legend_of_view(DebugView::presence).title, "Here for, min");
  EXPECT_EQ(ticks_of(DebugView::presence), "0 2 4 6 8 10+ ");
}

TEST_F(Legends, OfAMeasureHaveTheColoursThatPeopleHave) {
  const LegendRamp ramp = legend_of_view(DebugView::speed).ramp.value();
  for (std::size_t i = 0; i < ramp.colors.size(); i += 8) {
    const float share = static_cast<float>(i) / static_cast<float>(ramp.colors.size() - 1);
    EXPECT_EQ(ramp.colors[i], debug_color(tuning, {.measure = share * tuning.top_speed}));
  }
  EXPECT_EQ(debug_color(tuning, {.measure = 9.0F}), ramp.colors.back());
}

TEST_F(Legends, OfPresenceSayThatItHasNoEffectWhereNoFileIsPlayed) {
  EXPECT_THAT(legend_of_view(DebugView::presence).notes, ElementsAre(testing::StartsWith("No effect")));
  tuning.scene = Scene::tracks;
  EXPECT_THAT(legend_of_view(DebugView::presence).notes, IsEmpty());
}

TEST_F(Legends, SayWhoIsSelectedAndLeaveOutWhatIsNotDrawn) {
  report.selected.emplace();
  EXPECT_EQ(legend_of_view(DebugView::error).steps.back().color, selected_color);
  tuning.taken_away.drawing = true;
  EXPECT_THAT(legend(), IsEmpty());
}

TEST_F(Legends, OfRingsAndFiguresSayHowManyHaveRoom) {
  tuning.inspection.thresholds = tuning.inspection.figures_above_heads = true;
  report.heads.resize(300);
  const std::vector<LegendPart> parts = legend_of(report, tuning, 42);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts.front().title, "Interval, rings and heads");
  EXPECT_THAT(parts.front().notes, testing::Contains("42 of 300 figures have room"));
}

TEST_F(Legends, OfTheDifferenceSayHowBrightItIs) {
  tuning.inspection.split = Split::difference;
  ASSERT_EQ(legend().size(), 1U);
  EXPECT_EQ(legend().front().title, "Difference, times 8");
  tuning.inspection.split = Split::shown;
  EXPECT_THAT(legend(), IsEmpty()) << "words at the line say it";
}

TEST_F(Legends, OfTheViewerSayHowMuchFollowsTheBone) {
  report.viewer.emplace();
  EXPECT_THAT(legend(), IsEmpty());
  report.viewer->bones = {"hips", "spine"};
  report.viewer->settings.weighed_bone = 1;
  report.viewer->settings.bounds = true;
  ASSERT_EQ(legend().size(), 2U);
  EXPECT_EQ(legend().front().title, "Follows spine");
  EXPECT_THAT(words_of(legend().front()), ElementsAre("0 %", "25 %", "50 %", "75 %", "100 %"));
  EXPECT_EQ(legend().front().steps[4].color, weight_color(1.0F));
  EXPECT_EQ(legend().back().steps.front().color, bounds_color);
}

}  // namespace
}  // namespace throng::app::legend_test
