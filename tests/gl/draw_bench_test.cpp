// `throng bench --draw`, and how many calls a picture of a crowd takes.
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/commands/bench/drawing.h"
#include "app/show/opened_show.h"
#include "app/show/painter.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"

namespace throng::app::draw_bench_test {
namespace {

using testing::HasSubstr;
using testing::Not;

BenchOptions of_small_crowds() {
  BenchOptions options;
  options.draws = true;
  options.agents = {20, 60};
  options.frames = 3;
  options.shown.context = ContextKind::egl;
  options.shown.force_software = true;
  options.shown.width = 160;
  options.shown.height = 90;
  return options;
}

BenchReport measured(const BenchOptions& options) {
  auto report = measure_drawing(options);
  if (!report) return ADD_FAILURE() << report.error().message, BenchReport{};
  return std::move(*report);
}

TEST(BenchOfDrawing, SaysWhatWasDrawnOnWhichDevice) {
  const Json json = measured(of_small_crowds()).json;
  EXPECT_THAT(json["device"].get<std::string>(), HasSubstr("llvmpipe"));
  EXPECT_EQ(json["context"].get<std::string>(), "egl");
  EXPECT_TRUE(json["is_software"].get<bool>());
  EXPECT_EQ(json["size"].dump(), "[160,90]");
  EXPECT_EQ(json["samples"].get<int>(), 0);
  EXPECT_EQ(json["scene"].get<std::string>(), "plaza");
  EXPECT_EQ(json["camera"].get<std::string>(), "front");
  EXPECT_GT(json["pus"].get<int>(), 0);
  for (const char* const key :
       {"gl_version", "shadows", "crowd_shade", "scenery", "model", "error_px", "seconds", "rows"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
}

TEST(BenchOfDrawing, HasARowOfEachNumberOfAgentsWhosePartsAreOfTheFrame) {
  const Json json = measured(of_small_crowds()).json;
  ASSERT_EQ(json["rows"].elements().size(), 2U);
  EXPECT_EQ(json["rows"].elements()[0]["agents"].get<int>(), 20);
  for (const Json& row : json["rows"].elements()) {
    EXPECT_EQ(row["frames"].get<int>(), 3);
    EXPECT_FALSE(row["stopped"].get<bool>());
    EXPECT_GT(row["agents_in_view"].get<int>(), 0);
    EXPECT_GT(row["triangles"].get<int>(), 1000);
    EXPECT_GT(row["draw_calls"].get<int>(), 1);
    EXPECT_TRUE(row["device_ms_median"].is_null()) << "a processor has no clock of its own";
    const auto frame = row["frame_ms_median"].get<double>();
    EXPECT_GT(frame, 0.0);
    for (const char* const part : {"crowd", "cull", "pose", "upload", "submission", "wait"}) {
      const auto milliseconds = row[std::string(part) + "_ms_median"].get<double>();
      EXPECT_GT(milliseconds, 0.0) << part;
      EXPECT_LT(milliseconds, frame) << part << ": so is each of the frames, and so are medians";
    }
  }
}

TEST(BenchOfDrawing, IsATableForAPersonThatSaysWhyAProcessorHasNoClock) {
  const std::string text = measured(of_small_crowds()).text;
  EXPECT_THAT(text, HasSubstr("llvmpipe"));
  EXPECT_THAT(text, HasSubstr("160x90, one sample a pixel, no shadows, scenery, mannequin (built in), "
                              "scene plaza, camera front, "));
  for (const char* const column :
       {"agents", "agents_in_view", "frames", "frame_ms", "crowd_ms", "cull_ms", "pose_ms"}) {
    EXPECT_THAT(text, HasSubstr(column));
  }
  EXPECT_THAT(text, HasSubstr("The device is a processor"));
  EXPECT_THAT(text, Not(HasSubstr("stopped")));
}

TEST(BenchOfDrawing, StopsANumberOfAgentsThatTakesTooLongAndSaysSo) {
  BenchOptions options = of_small_crowds();
  options.agents = {20};
  options.frames = 100'000;
  options.seconds = 0.001F;
  const BenchReport report = measured(options);
  const Json& row = report.json["rows"].elements()[0];
  EXPECT_TRUE(row["stopped"].get<bool>());
  EXPECT_EQ(row["frames"].get<int>(), 1);
  EXPECT_THAT(report.text, HasSubstr("20 agents were stopped after"));
}

TEST(BenchOfDrawing, IsDrawnAsALineOfEachPart) {
  const std::string plot = measured(of_small_crowds()).plot;
  for (const char* const name : {">frame<", ">crowd<", ">cull<", ">pose<", ">upload<", ">submission<", "llvmpipe"}) {
    EXPECT_THAT(plot, HasSubstr(name));
  }
  EXPECT_THAT(plot, Not(HasSubstr("own clock"))) << "there is none";
}

TEST(BenchOfDrawing, RefusesACameraThatTheSceneLacks) {
  BenchOptions options = of_small_crowds();
  options.shown.camera_name = "beneath";
  const auto report = measure_drawing(options);
  ASSERT_FALSE(report);
  EXPECT_THAT(report.error().message, HasSubstr("beneath"));
}

std::uint32_t draw_calls_of(int agents) {
  DemoOptions options = of_small_crowds().shown;
  options.tuning.agents = agents;
  options.values_given.keys.emplace_back("agents");
  options.camera_name = "above";  // everybody is in view
  StartError error;
  const std::unique_ptr<Show> show = open_show(options, error);
  if (show == nullptr) return ADD_FAILURE() << error.message, 0;
  show->animate(ticks_per_second / 60);
  EXPECT_TRUE(show->draw());
  EXPECT_GT(show->stage().posed().selection().visible.size(), static_cast<std::size_t>(agents) / 2);
  return show->painter().draw_counts().draw_calls;
}

TEST(DrawCalls, OfTenThousandAreAtMostTwiceThoseOfAHundred) {
  EXPECT_LE(draw_calls_of(10'000), 2 * draw_calls_of(100));
}

}  // namespace
}  // namespace throng::app::draw_bench_test
