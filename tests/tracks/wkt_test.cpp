#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/tracks/file_plan.h"
#include "tests/tracks/track_file.h"

namespace throng::wkt_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string fault(std::string_view text) {
  const auto plan = parse_wkt(text);
  return plan ? std::string() : plan.error().message;
}

TEST(Wkt, ReadsEveryKindOfGeometry) {
  const auto plan = parse_wkt(
      "# a place\nSRID=4326;POINT (1 2)\nLINESTRING (0 0, 1 0, 1 1)\n"
      "polygon z ((0 0 0, 4 0 0, 4 4 0, 0 4 0, 0 0 0), (1 1 0, 2 1 0, 2 2 0, 1 1 0)); MULTIPOINT ((1 2), (3 4), 5 6)\n"
      "MULTILINESTRING ((0 0, 1 1), (2 2, 3 3, 4 4))\nMULTIPOLYGON (((9 9, 8 9, 8 8)), ((6 6, 7 6, 7 7), EMPTY))\n"
      "GEOMETRYCOLLECTION (POINT EMPTY, GEOMETRYCOLLECTION (LINESTRING (5 5, 6 6)), POLYGON EMPTY)\n");
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->walls.size(), 4U);
  ASSERT_EQ(plan->floors.size(), 3U);
  EXPECT_EQ(plan->floors[0].outline.size(), 4U);
  ASSERT_EQ(plan->floors[0].holes.size(), 1U);
  EXPECT_EQ(plan->floors[0].holes[0].size(), 3U);
}

TEST(Wkt, TakesADimensionThatIsWrittenToTheName) {
  const auto plan = parse_wkt("LineStringZ (0 0 1, 1 0 1) POLYGONZM((0 0 1 2, 4 0 1 2, 4 4 1 2)) POINTM (1 2 3)");
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->walls.size(), 1U);
  EXPECT_EQ(plan->floors.size(), 1U);
}

TEST(Wkt, TakesAPolygonWithinAnotherAsAnObstacle) {
  const auto plan =
      parse_wkt("POLYGON ((0 0, 9 0, 9 9, 0 9)) POLYGON ((1 1, 2 1, 2 2, 1 2)) POLYGON ((20 0, 29 0, 29 9))");
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->floors.size(), 2U);
  EXPECT_EQ(plan->obstacles.size(), 1U);
}

/// Polygons of so many corners around (0, 0), each within the next.
std::string nested_polygons(int count, int corners) {
  std::string text;
  for (int polygon = 1; polygon <= count; ++polygon) {
    text += "POLYGON ((";
    for (int i = 0; i < corners; ++i) {
      const double turn = 6.28318530718 * i / corners;
      text += std::to_string(polygon * std::cos(turn)) + " " + std::to_string(polygon * std::sin(turn)) + ",";
    }
    text.back() = ')';
    text += ")";
  }
  return text;
}

TEST(Wkt, RefusesPolygonsThatTakeTooLongToCompare) {
  EXPECT_EQ(fault(nested_polygons(20, 40)), "");
  EXPECT_THAT(fault(nested_polygons(700, 1000)), HasSubstr("its 700 polygons take too long to compare; write"));
}

TEST(Wkt, SaysLineAndRemedyOfWhatIsBroken) {
  EXPECT_THAT(fault("LINESTRING (0 0, 1 1)\nPOLYGON ((0 0, 1 x, 2 2))"),
              StartsWith("line 2: a number should be where \"x, 2 2))\" is; write WKT, such as POLYGON (("));
  EXPECT_THAT(fault("POLYGON ((0 0, 1 1, 2 0)"), HasSubstr("it ends where a ) should be"));
  EXPECT_THAT(fault("CIRCLE (0 0, 1)"), HasSubstr("\"CIRCLE\" is no geometry"));
  EXPECT_THAT(fault("POLYGON ((0 0, 1 1))"), HasSubstr("fewer than three corners"));
  EXPECT_THAT(fault("LINESTRING (0 0)"), HasSubstr("a single point"));
  EXPECT_THAT(fault("LINESTRING (0 0, 1 nan)"), HasSubstr("a number should be where \"nan)\""));
  EXPECT_THAT(fault("12 POLYGON"), HasSubstr("a geometry should be where"));
  std::string deep;
  for (int i = 0; i < 1000; ++i) deep += "GEOMETRYCOLLECTION (";
  EXPECT_THAT(fault(deep), HasSubstr("more than 16 deep"));
}

TEST(Wkt, TakesASystemOfCoordinatesOnce) {
  std::string many;
  for (int i = 0; i < 40'000; ++i) many += "SRID=1;";
  EXPECT_THAT(fault(many + "POINT (1 2)"), HasSubstr("\"SRID\" is no geometry that is read here"));
}

TEST(Wkt, SkipsAnyNumberOfComments) {
  std::string many;
  for (int i = 0; i < 200'000; ++i) many += "#\n";
  EXPECT_EQ(fault(many + "POINT (1 2)"), "");
}

TEST(Walls, StandAboutTheOriginOfTheCrowd) {
  const TrackFolder folder;
  const std::string walls = folder.file("walls.wkt", "LINESTRING (1000000.25 2000000, 1000010.25 2000000)\n");
  const auto tracks = read_trajectories(
      folder.file("a.csv", "id,time,x,y\n1,0,1000000,2000000\n1,1,1000010.5,2000010\n"), {.walls = walls});
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->origin, glm::dvec2(1000005.0, 2000005.0));
  ASSERT_EQ(tracks->plan.walls.size(), 1U);
  EXPECT_EQ(tracks->plan.walls[0].points[0], glm::vec2(-4.75F, 5.0F));
  const auto alone = read_ground_plan(walls, tracks->origin);
  ASSERT_TRUE(alone) << alone.error().message;
  EXPECT_EQ(alone->walls[0].points[0], glm::vec2(-4.75F, 5.0F));
}

TEST(Walls, MayBeInCentimetres) {
  const TrackFolder folder;
  const auto tracks =
      read_trajectories(folder.file("a.csv", "id,time,x,y\n1,0,0,0\n1,9,10,5\n"),
                        {.walls = folder.file("walls.wkt", "POLYGON ((0 0, 1000 0, 1000 500, 0 500, 0 0))")});
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->plan.floors[0].outline[1].x - tracks->plan.floors[0].outline[0].x, 10.0F);
  EXPECT_THAT(all_said(*tracks), HasSubstr("Walls are taken as centimetres"));
}

TEST(Walls, AreRefusedByTheirOwnName) {
  const TrackFolder folder;
  const std::string rows = folder.file("a.csv", "id,time,x,y\n1,0,0,0\n");
  for (const char* const text : {"", "BOX (1 2)", "{\"a\": 1}", "{", "\xFF\xFE P"}) {
    const auto tracks = read_trajectories(rows, {.walls = folder.file("walls.wkt", text)});
    ASSERT_FALSE(tracks) << text;
    EXPECT_THAT(tracks.error().message, StartsWith(folder.path("walls.wkt") + ": ")) << text;
    EXPECT_THAT(tracks.error().message, HasSubstr("; ")) << text;
  }
  EXPECT_FALSE(read_trajectories(rows, {.walls = folder.path("none.wkt")}));
}

TEST(Floor, HasObstaclesOfClosedWallsAndWallsOfOthers) {
  const auto plan = parse_floor(
      "<?xml version=\"1.0\"?><floor><layer id=\"0\"><wall closed=\"true\"><point x=\"1\" y=\"2\"/>"
      "<point x=\"2\" y=\"2\"/><point x=\"2\" y=\"3\"/></wall><wall closed=\"false\"><point x=\"5\" y=\"5\"/>"
      "<point x=\"6\" y=\"5\"/></wall><wunderZone><point x=\"9\" y=\"9\"/></wunderZone></layer></floor>");
  ASSERT_TRUE(plan) << plan.error().message;
  ASSERT_EQ(plan->obstacles.size(), 1U);
  EXPECT_EQ(plan->obstacles[0].size(), 3U);
  ASSERT_EQ(plan->walls.size(), 1U);
  EXPECT_TRUE(plan->floors.empty());
}

TEST(Floor, OfOneClosedWallIsWhatItEncloses) {
  const auto plan = parse_floor(
      "<floor><wall closed=\"true\"><point x=\"1\" y=\"2\"/><point x=\"2\" y=\"2\"/><point x=\"2\" "
      "y=\"3\"/></wall></floor>");
  ASSERT_TRUE(plan) << plan.error().message;
  EXPECT_EQ(plan->floors.size(), 1U);
  EXPECT_TRUE(plan->obstacles.empty());
}

TEST(Floor, IsRefusedWithItsLineAndARemedy) {
  const auto error = [](std::string_view text) {
    const auto plan = parse_floor(text);
    return plan ? std::string() : plan.error().message;
  };
  EXPECT_EQ(error("<net/>"), "line 1: <net> is no floor of crowd:it; name a .floor, or walls as WKT");
  EXPECT_EQ(error("<floor>\n<wall><point x=\"a\" y=\"1\"/></wall></floor>"),
            "line 2: a point has no x and y in metres; put them there");
  EXPECT_THAT(error("<floor>\n<wall>"), StartsWith("line 2: it is no whole XML"));
  EXPECT_THAT(error("<!DOCTYPE floor><floor/>"), HasSubstr("DOCTYPE"));
  EXPECT_EQ(error("<floor/>"), "it has no wall with points; export it again");
}

TEST(PlanBeside, IsTheFileWithTheNameOfTheTrajectories) {
  const TrackFolder folder;
  const std::string rows = folder.file("walk.csv", "id,time,x,y\n1,0,1,1\n1,1,2,1\n");
  EXPECT_TRUE(read_trajectories(rows, {})->plan.is_empty());
  const std::string walls = folder.file("walk.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4))");
  const auto tracks = read_trajectories(rows, {});
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->plan.floors.size(), 1U);
  EXPECT_THAT(all_said(*tracks), HasSubstr("The place is that of " + walls));
  folder.file("walk.wkt", "POLYGON ((0 0, 4 0");
  const auto broken = read_trajectories(rows, {});
  ASSERT_FALSE(broken);
  EXPECT_THAT(broken.error().message, StartsWith(walls + ": line 1"));
}

}  // namespace
}  // namespace throng::wkt_test
