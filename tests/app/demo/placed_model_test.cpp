// What a person is told of the size and place that were asked for.
#include "app/demo/placed_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/demo/frame_reporter.h"
#include "tests/app/recording/recorded_run.h"

namespace throng::app::placed_model_test {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

TEST(PlacedModel, SaysTheScaleAndHowLongItTook) {
  const auto show = test::show_of(test::demo("--agents 3"));
  Messages messages;
  place_model(*show, {.character = 0, .choice = {.scale = 2.0}}, messages);
  EXPECT_THAT(
      messages.all().back().words,
      MatchesRegex("mannequin \\(built in\\): 3\\.6 m tall: scaled by 2 as asked; made anew in [0-9]+\\.[0-9] s"));
  place_model(*show, {.character = 0, .choice = {.scale = 1e12}}, messages);
  EXPECT_THAT(messages.all().back().words, HasSubstr("beyond all measure"));
  EXPECT_EQ(messages.all().back().kind, Message::Kind::refused);
}

TEST(PlacedModel, IsReportedFromTheNextFrameOn) {
  const auto show = test::show_of(test::demo("--agents 3"));
  FrameReporter reporter(*show);
  EXPECT_EQ(reporter.report().placement.scale, 1.0);
  EXPECT_EQ(reporter.report().placement.guessed_scale, 1.0);
  Messages messages;
  place_model(*show, {.character = 0, .choice = {.scale = 0.5}}, messages);
  show->animate(test::sixtieth);
  reporter.update(*show, {}, 16.0);
  EXPECT_EQ(reporter.report().placement.scale, 0.5);
  EXPECT_EQ(reporter.report().placement.guessed_scale, 1.0);
  EXPECT_NEAR(reporter.report().placement.units_tall, 1.8, 0.05);
  EXPECT_EQ(reporter.report().placement.choice, (anim::PlacementChoice{.scale = 0.5}));
}

}  // namespace
}  // namespace throng::app::placed_model_test
