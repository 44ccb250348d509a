// A show of rows that come, beside one of the same rows in a file.

#include <cmath>
#include <memory>
#include <string>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/show/opened_show.h"
#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"
#include "tests/tracks/live/live_feed.h"
#include "tests/tracks/track_file.h"

namespace throng::app::live_show_test {
namespace {

using test::demo;
using test::sixtieth;
using testing::HasSubstr;

/// Five people who walk round in circles one after the other, as a camera sees them 10 times a second.
std::string circles() {
  std::string text = "id,time,x,y\n";
  for (int row = 0; row < 120; ++row) {
    for (int person = 0; person < 5; ++person) {
      const double seconds = 0.1 * row - 0.7 * person, angle = 1.2 * seconds / (2.0 + person);
      if (seconds < 0.0 || seconds > 6.0) continue;
      text += std::to_string(person) + "," + std::to_string(0.1 * row) + "," +
              std::to_string((2.0 + person) * std::cos(angle)) + "," +
              std::to_string((2.0 + person) * std::sin(angle)) + "\n";
    }
  }
  return text;
}

class LiveShow : public testing::Test {
 protected:
  std::unique_ptr<Show> live(const std::string& options, const std::string& text) {
    feed_.send_all(text);
    StartError error;
    auto show = open_show(demo("--trajectories - " + options), error, feed_.read());
    EXPECT_NE(show, nullptr) << error.message;
    return show;
  }
  static bool is_over(const Show& show) { return show.live()->has_ended(); }
  static void animate(Show& show) {
    while (!show.has_rows_for(sixtieth, std::chrono::milliseconds(100))) {
    }
    show.animate(sixtieth);
  }

  const TrackFolder folder_;
  LiveFeed feed_;
};

TEST_F(LiveShow, IsThatOfTheSameRowsInAFile) {
  const std::string text = circles();
  const auto recorded = test::show_of(demo("--trajectories " + folder_.file("circles.csv", text)));
  const auto show = live("--agents 5", text);
  const glm::dvec2 apart = show->stage().trajectories()->origin - recorded->stage().trajectories()->origin;
  const glm::vec3 moved(apart.x, 0.0, -apart.y);
  int frames = 0, seen = 0;
  double turned = 0.0, strode = 0.0;
  for (; !is_over(*show); ++frames) {
    recorded->animate(sixtieth);
    animate(*show);
    const Crowd &crowd = show->stage().crowd(), &other = recorded->stage().crowd();
    ASSERT_NEAR(crowd.tracks()->clock().seconds, other.tracks()->clock().seconds, 1e-6);
    for (std::uint32_t agent = 0; agent < crowd.size(); ++agent) {
      ASSERT_EQ(absent_of(crowd)[agent], absent_of(other)[agent]) << agent << " in frame " << frames;
      if (absent_of(crowd)[agent] != 0) continue;
      ++seen;
      ASSERT_LT(glm::distance(crowd.positions()[agent] + moved, other.positions()[agent]), 1e-3F);
      const double seconds = crowd.tracks()->clock().seconds;
      const TrackStep step = crowd.tracks()->people().step(agent, seconds);
      const TrackStep step_of_file = other.tracks()->people().step(agent, seconds);
      turned = std::max(turned, std::abs(std::remainder(step.heading - step_of_file.heading, 6.2831853)));
      strode = std::max(strode, std::abs(std::remainder(step.cycles - step_of_file.cycles, 256.0)));
    }
  }
  EXPECT_GT(frames, 500);
  EXPECT_GT(seen, 1500);
  EXPECT_LT(turned, 0.02);
  EXPECT_LT(strode, 0.02);
}

TEST_F(LiveShow, EndsWithWhatItHasWhereTheTextIsWrong) {
  const auto show = live("--agents 3", "id,time,x,y\n1,0,0,0\n1,1,1,0\n1,2,two,0\n");
  while (!is_over(*show)) animate(*show);
  EXPECT_EQ(absent_of(show->stage().crowd())[0], 0);
  EXPECT_FALSE(show->live()->status());
  EXPECT_THAT(show->notice(), HasSubstr("-: line 4: \"two\" is not a number"));
}

TEST_F(LiveShow, HasItsWallsAboutTheFirstRow) {
  const std::string walls = folder_.file("hall.wkt", "POLYGON ((100 200, 110 200, 110 210, 100 210, 100 200))\n");
  const auto show = live("--agents 3 --walls " + walls, "id,time,x,y\n1,0,105,205\n1,1,106,205\n");
  const GroundPlan& plan = show->stage().trajectories()->plan;
  ASSERT_EQ(plan.floors.size(), 1U);
  EXPECT_EQ(plan.floors[0].outline[0], glm::vec2(-5.0F, 5.0F));
}

TEST_F(LiveShow, GoesOnWithOtherCharactersAndOtherValues) {
  const auto show = live("--agents 5", circles());
  for (int frame = 0; frame < 60; ++frame) animate(*show);
  const double before = show->stage().crowd().tracks()->clock().seconds;
  test::change(*show, [](Tuning& tuning) { tuning.seed = 7; });
  animate(*show);
  EXPECT_NEAR(show->stage().crowd().tracks()->clock().seconds, before + 1.0 / 60.0, 1e-6);
  EXPECT_EQ(absent_of(show->stage().crowd())[0], 0);
}

// Ann stays for so long that her first rows are forgotten. Then Bob takes the only place.
TEST_F(LiveShow, KnowsWhenSomebodyCame) {
  std::string text = "id,time,x,y\n";
  for (int row = 0; row < 400; ++row) {
    text += std::string(row < 250 ? "ann" : "bob") + "," + std::to_string(0.1 * row) + ",1,2\n";
  }
  const auto show = live("--agents 1", text);
  const auto came_at = [&] { return show->stage().crowd().tracks()->people().presence(0).first; };
  for (int frame = 0; frame < 1400; ++frame) animate(*show);
  EXPECT_EQ(came_at(), 0.0);
  while (!is_over(*show)) animate(*show);
  EXPECT_EQ(show->stage().trajectories()->persons[0].id, "bob");
  EXPECT_GE(came_at(), 25.0);
}

TEST_F(LiveShow, HoldsAllThatCameInItsPicture) {
  std::string text = "id,time,x,y\n";
  for (int row = 0; row < 80; ++row)
    text += "ann," + std::to_string(0.1 * row) + "," + std::to_string(0.4 * row) + ",0\n";
  const auto show = live("--agents 5", text);
  animate(*show);
  const float before = show->view().camera.position.y;
  while (!is_over(*show)) animate(*show);
  EXPECT_GT(show->view().camera.position.y, before + 3.0F);
}

}  // namespace
}  // namespace throng::app::live_show_test
