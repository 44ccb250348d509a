#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tracks/track_file.h"

namespace throng::doubts_test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Five people who go along x, with `more` behind each row.
std::string walk(const std::string& header, double metres_a_row, double time_a_row, const std::string& more = "",
                 double apart = 1.0) {
  std::string text = header;
  for (int row = 0; row < 30; ++row) {
    for (int person = 1; person <= 5; ++person) {
      text += std::to_string(person) + "," + std::to_string(row * time_a_row) + "," +
              std::to_string(row * metres_a_row) + "," + std::to_string(person * apart) + more + "\n";
    }
  }
  return text;
}

std::string said_of(const std::string& text, const TrackReading& options = {}) {
  const auto tracks = read_as("a.csv", text, options);
  return tracks ? all_said(*tracks) : tracks.error().message;
}

TEST(Doubts, AreOfSpeedsThatNoCrowdHas) {
  const std::string centimetres = walk("id,time,x,y\n", 13.0, 0.1, "", 100.0);
  EXPECT_THAT(said_of(centimetres), HasSubstr("People go 130 m/s in the middle of all steps, which is too fast to be "
                                              "true: --unit cm, the metres of a pixel as --unit 0.02, or --time-unit"));
  EXPECT_EQ(said_of(centimetres, {.metres_a_unit = 0.01}), "");
  const std::string milliseconds = walk("id,time,x,y\n", 0.13, 100.0);
  EXPECT_THAT(said_of(milliseconds), HasSubstr("People go 0.0013 m/s at the most, which is too slow to be true: "
                                               "--time-unit ms, or --unit, may mend it."));
  EXPECT_EQ(said_of(milliseconds, {.times_a_second = 1000.0}), "");
  EXPECT_THAT(said_of(walk("id,frame,x,y\n", 0.13, 3000.0)), HasSubstr("too slow to be true: --fps or --unit may"));
  for (const double metres : {0.0, 0.001, 0.13, 0.6}) EXPECT_EQ(said_of(walk("id,time,x,y\n", metres, 0.1)), "");
}

TEST(Doubts, AreOfPeopleWhoAllStandAtOnePlace) {
  const std::string degrees = walk("id,time,x,y\n", 1e-6, 0.1, "", 1e-4);
  EXPECT_THAT(said_of(degrees), HasSubstr("All 5 people stay within 0.0004 m, as places in degrees or kilometres do"));
  EXPECT_EQ(said_of(walk("id,time,x,y\n", 0.00013, 0.1, "", 0.001), {.metres_a_unit = 1000.0}), "");
}

TEST(Doubts, AreOfHeightsThatNoHeadsAndNoGroundHas) {
  EXPECT_THAT(said_of(walk("id,time,x,y,z\n", 0.13, 0.1, ",35.5")),
              HasSubstr("People stand at heights from 36 m to 36 m, and the ground is drawn at 0: --height none"));
  EXPECT_EQ(said_of(walk("id,time,x,y,z\n", 0.13, 0.1, ",35.5"), {.height = TrackHeight::none}), "");
  EXPECT_THAT(said_of(walk("id,time,x,y,z\n", 0.13, 0.1, ",0.6"), {.height = TrackHeight::head}),
              HasSubstr("People are 0.60 m tall in the middle, by the heights of their heads: --unit may mend it"));
}

TEST(Doubts, AreOfAPlaceFarFromAllPeople) {
  const TrackFolder folder;
  const std::string rows = folder.file("a.csv", walk("id,time,x,y\n", 0.13, 0.1));
  const auto away =
      read_trajectories(rows, {.walls = folder.file("away.wkt", "POLYGON ((500 0, 520 0, 520 9, 500 9))")});
  ASSERT_TRUE(away) << away.error().message;
  EXPECT_THAT(all_said(*away), HasSubstr("The walls and floors lie 496 m away from all people: --walls takes others."));
  const auto here = read_trajectories(rows, {.walls = folder.file("here.wkt", "POLYGON ((0 0, 9 0, 9 9, 0 9))")});
  ASSERT_TRUE(here) << here.error().message;
  EXPECT_EQ(all_said(*here), "");
}

TEST(Doubts, AreOfShapesThatAreLeftOut) {
  const TrackFolder folder;
  const std::string walls =
      folder.file("a.scenario", R"({"topography": {"obstacles": [{"shape": {"type": "ELLIPSE", "axes": [1, 2]}},
                       {"shape": {"x": 0, "y": 0, "width": 9, "height": 9}}], "targets": [{"shape": {"type": "SPLINE"}}]}})");
  const auto tracks = read_trajectories(folder.file("a.csv", walk("id,time,x,y\n", 0.13, 0.1)), {.walls = walls});
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_THAT(all_said(*tracks), HasSubstr("2 shapes of the place are left out, for a shape has corners, sides or a"));
}

/// People who walk in a circle; each looks `aside` degrees to the left of the way, as the file's angles have it.
std::string circle(double aside, bool is_clockwise_from_north) {
  std::string text = "id,time,x,y,angle\n";
  for (int i = 0; i < 60; ++i) {
    const double turn = 0.12 * i, angle = turn * 180.0 / std::numbers::pi + 90.0 + aside;
    text += "1," + std::to_string(i * 0.2) + "," + std::to_string(2.0 * std::cos(turn)) + "," +
            std::to_string(2.0 * std::sin(turn)) + "," +
            std::to_string(std::remainder(is_clockwise_from_north ? 90.0 - angle : angle, 360.0)) + "\n";
  }
  return text;
}

TEST(Doubts, AreOfAnglesThatDoNotPointWhereTheyGo) {
  for (const double aside : {90.0, -90.0, 180.0}) {
    const std::string said = said_of(circle(aside, false));
    EXPECT_THAT(said, HasSubstr("People do not go where their angles point")) << aside;
    EXPECT_THAT(said, HasSubstr("on the average: --angle none has people look where they go."));
  }
  EXPECT_THAT(said_of(circle(0.0, false)), Not(HasSubstr("do not go")));
  EXPECT_THAT(said_of(circle(20.0, false)), Not(HasSubstr("do not go")));
  const auto none = read_as("a.csv", circle(90.0, false), {.angle = TrackAngle::none});
  ASSERT_TRUE(none) << none.error().message;
  EXPECT_TRUE(std::isnan(none->persons[0].rows[0].heading));
  EXPECT_EQ(all_said(*none), "");
}

TEST(Doubts, NameTheOptionThatTurnsAngles) {
  std::string text = circle(0.0, true);
  text.replace(text.find("angle"), 5, "angle [deg]");
  EXPECT_THAT(said_of(text), HasSubstr("on the average: with --angle north they do."));
  EXPECT_EQ(said_of(text, {.angle = TrackAngle::north}), "");
}

// Angles that no name explains are read as they agree.
TEST(Doubts, AreSparedWhereAnglesClockwiseFromNorthAgree) {
  const auto tracks = read_as("a.csv", circle(0.0, true));
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_THAT(all_said(*tracks), HasSubstr("Angles are degrees clockwise from north: so they agree"));
  EXPECT_NEAR(std::abs(tracks->persons[0].rows[0].heading), std::numbers::pi, 1e-4);  // to the north
}

TEST(Doubts, NameAnOptionThatIsNotUsed) {
  EXPECT_THAT(said_of(walk("id,time,x,y\n", 0.13, 0.1), {.fps = 25.0}), HasSubstr("--fps is not used"));
  EXPECT_THAT(said_of(walk("id,frame,x,y\n", 0.04, 1.0), {.fps = 25.0, .times_a_second = 1000.0}),
              HasSubstr("--time-unit is not used"));
}

}  // namespace
}  // namespace throng::doubts_test
