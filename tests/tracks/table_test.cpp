#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/tracks/raw_rows.h"
#include "engine/tracks/text/number_text.h"
#include "engine/tracks/text/table_layout.h"
#include "tests/tracks/track_file.h"

namespace throng::table_test {
namespace {

using testing::HasSubstr;

TEST(TrackTable, ReadsColumnsByName) {
  const auto tracks = read_as("a.csv", "id,time,x,y,z\nann,0.0,1.5,2,0.25\nbob,0.0,4,5,0\nann,0.5,1.75,2.5,0.5\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  ASSERT_EQ(tracks->persons.size(), 2U);
  const PersonTrack& ann = tracks->persons[0];
  EXPECT_EQ(ann.id, "ann");
  ASSERT_EQ(ann.rows.size(), 2U);
  EXPECT_EQ(ann.rows[1].seconds, 0.5);
  EXPECT_EQ(file_place(*tracks, ann.rows[1]), glm::dvec2(1.75, 2.5));
  EXPECT_EQ(ann.rows[1].y, 0.5F);
  EXPECT_TRUE(std::isnan(ann.rows[0].heading));
  EXPECT_EQ(tracks->row_count, 3U);
  EXPECT_EQ(tracks->rows_a_second, 2.0);
  EXPECT_EQ(tracks->format, "table with a header");
}

TEST(TrackTable, TellsSeparatorsQuotesCaseAndEndsOfLinesApart) {
  for (const char* const text : {
           "Agent;T;POS_X;Pos_Y\n7;1;2;3\n7;2;2;4\n",
           "person_id\ttime\tx_pos\ty_pos\n7\t1\t2\t3\n7\t2\t2\t4\n",
           "pedID, seconds, X [m], Y [m]\r\n7, 1, 2, 3\r\n7, 2, 2, 4\r\n",
           "id time x y\n7  1 2   3\n  7 2 2 4",
           "\xEF\xBB\xBF\"id\",\"t(s)\",\"x(m)\",\"y(m)\"\n\"7\",\"1\",\"2\",3\n7,2,2,\"4\"\n",
           "# made by hand\n\nid,time,x,y,note\n7,1,2,3,\"a, b\"\n\n# more\n7,2,2,4,\n",
           "$PEDESTRIAN:NO;SIMSEC;COORDCENTX;COORDCENTY\n7;1;2;3\n7;2;2;4\n",
       }) {
    const auto tracks = read_as("a.csv", text);
    ASSERT_TRUE(tracks) << tracks.error().message << "\n" << text;
    ASSERT_EQ(tracks->persons.size(), 1U) << text;
    EXPECT_EQ(tracks->persons[0].id, "7") << text;
    ASSERT_EQ(tracks->persons[0].rows.size(), 2U) << text;
    EXPECT_EQ(tracks->persons[0].rows[0].seconds, 1.0) << text;
    EXPECT_EQ(file_place(*tracks, tracks->persons[0].rows[1]), glm::dvec2(2.0, 4.0)) << text;
  }
}

TEST(TrackTable, TakesUnitsOfTheHeader) {
  const auto tracks = read_as("a.csv", "id,time [ms],x [cm],y [cm]\n1,500,100,200\n1,1000,150,200\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->persons[0].rows[0].seconds, 0.5);
  EXPECT_EQ(file_place(*tracks, tracks->persons[0].rows[1]), glm::dvec2(1.5, 2.0));
  EXPECT_THAT(all_said(*tracks), HasSubstr("x is in cm"));
}

TEST(TrackTable, TakesALineOfUnitsBelowTheNames) {
  const auto tracks = read_as("pathfinder.csv",
                              "\"t\",\"id\",\"name\",\"x\",\"y\",\"v\",\"location\"\n"
                              "\"s\",\"\",\"\",\"cm\",\"cm\",\"m/s\",\"\"\n"
                              "0.0,0,\"00001\",-1011,-205,0.0,\"Room07\"\n1.0,0,\"00001\",-991,-203,0.3,\"Room07\"\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->row_count, 2U);
  EXPECT_NEAR(file_place(*tracks, tracks->persons[0].rows[0]).x, -10.11, 1e-6);
  EXPECT_EQ(error_of("a.csv", "t,id,x,y\ns,,m,\n0,1,2,z\n"),
            "a.csv: line 3: \"z\" is not a number; put y in metres there, or skip such rows with --lenient");
  EXPECT_THAT(error_of("a.csv", "t,id,x,y\ns,,parsecs,\n0,1,2,3\n"), HasSubstr("line 2: \"s\" is not a number"));
}

TEST(TrackTable, TakesTheIdOfPathfinderBeforeItsName) {
  const auto tracks = read_as("occupants.csv",
                              "\"t(s)\",\"id\",\"name\",\"active\",\"x(m)\",\"y(m)\",\"z(m)\",\"v(m/s)\"\n"
                              "0.0,3,\"Max, M\",1,1.0,2.0,3.0,0.5\n1.0,3,\"Max, M\",1,2.0,2.0,3.0,0.5\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->persons[0].id, "3");
  EXPECT_EQ(tracks->persons[0].rows[0].y, 3.0F);
  EXPECT_EQ(file_place(*tracks, tracks->persons[0].rows[1]), glm::dvec2(2.0, 2.0));
}

TEST(TrackTable, TakesTheCommonerOfTwoColumnsInAnyOrder) {
  const auto tracks = read_as("a.csv", "name,id,t,step,x,y\nMax,3,0.5,7,1,2\nMax,4,0.5,7,1,2\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->persons.size(), 2U);
  EXPECT_EQ(tracks->persons[0].rows[0].seconds, 0.5);
}

TEST(TrackTable, ListsColumnsThatItDoesNotKnowWithWhatWouldBeAccepted) {
  const std::string error = error_of("a.csv", "who,when,x,latitude\n1,2,3,4\n");
  EXPECT_THAT(error, HasSubstr("a.csv: line 1: its columns are \"who\", \"when\", \"x\" and \"latitude\""));
  EXPECT_THAT(error, HasSubstr("id (person, personid, agent, ...)"));
  EXPECT_THAT(error, HasSubstr("time (t, seconds, sec, ...) or frame (frameid, fr, f, ...)"));
  EXPECT_THAT(error, HasSubstr("y (posy, ypos, positiony, ...)"));
  EXPECT_THAT(error, testing::Not(HasSubstr("x (posx")));
}

TEST(TrackTable, TurnsAnglesIntoHeadings) {
  const auto tracks = read_as("a.csv", "id,time,x,y,angle [deg]\n1,0,0,0,0\n1,1,0,1,90\n1,2,0,2,180\n1,3,0,3,-90\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  const auto& rows = tracks->persons[0].rows;  // +x is east and +Z south, so east is a quarter turn from +Z
  EXPECT_NEAR(rows[0].heading, std::numbers::pi / 2.0, 1e-6);
  EXPECT_NEAR(std::abs(rows[1].heading), std::numbers::pi, 1e-6);
  EXPECT_NEAR(rows[2].heading, -std::numbers::pi / 2.0, 1e-6);
  EXPECT_NEAR(rows[3].heading, 0.0, 1e-6);
}

/// Somebody who walks in a circle and looks ahead; the angle times `unit`.
std::string circle(double unit) {
  std::string text = "id,time,x,y,angle\n";
  for (int i = 0; i < 40; ++i) {
    const double a = 0.15 * i;
    text += "1," + std::to_string(i * 0.2) + "," + std::to_string(2.0 * std::cos(a)) + "," +
            std::to_string(2.0 * std::sin(a)) + "," +
            std::to_string(unit * std::remainder(a + std::numbers::pi / 2.0, 2.0 * std::numbers::pi)) + "\n";
  }
  return text;
}

TEST(TrackTable, TellsRadiansFromDegrees) {
  const auto radians = read_as("a.csv", circle(1.0));
  ASSERT_TRUE(radians) << radians.error().message;
  EXPECT_THAT(all_said(*radians), HasSubstr("Angles are in radians"));
  const auto degrees = read_as("a.csv", circle(180.0 / std::numbers::pi));
  ASSERT_TRUE(degrees) << degrees.error().message;
  EXPECT_THAT(all_said(*degrees), HasSubstr("Angles are in degrees"));
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_NEAR(std::remainder(radians->persons[0].rows[i].heading - degrees->persons[0].rows[i].heading,
                               2.0 * std::numbers::pi),
                0.0, 1e-4);
  }
}

TEST(TrackTable, RefusesAnglesThatMayBeEither) {
  const std::string text = "id,time,x,y,angle\n1,0,0,0,1\n1,1,0,0,1.5\n";
  EXPECT_THAT(error_of("a.csv", text), HasSubstr("may be degrees or radians; say which with --angle"));
  EXPECT_TRUE(read_as("a.csv", text, {.angle = TrackAngle::radians}));
}

TEST(TrackTable, RefusesAnglesThatAgreeWithTheWaysInBothUnits) {
  std::string text = "id,time,x,y,angle\n";
  for (int i = 0; i < 20; ++i) text += "1," + std::to_string(i) + "," + std::to_string(i) + ",0,0.05\n";
  EXPECT_THAT(error_of("a.csv", text), HasSubstr("may be degrees or radians"));
}

TEST(TrackTable, TakesYAsUpWhereItIsTold) {
  const auto tracks = read_as("a.csv", "id,time,x,y,z\n1,0,1,0.5,3\n1,1,2,0.5,4\n", {.up = TrackUp::y});
  ASSERT_TRUE(tracks) << tracks.error().message;
  const TrackRow& row = tracks->persons[0].rows[1];
  EXPECT_EQ(row.y, 0.5F);
  EXPECT_EQ(file_place(*tracks, row), glm::dvec2(2.0, -4.0));  // z stays z
}

TEST(TrackTable, DoubtsThatHeadsAreTheGround) {
  const std::string text = "id,time,x,y,z\n1,0,1,1,1.7\n1,1,2,1,1.75\n2,0,3,3,1.6\n";
  const auto ground = read_as("a.csv", text);
  ASSERT_TRUE(ground) << ground.error().message;
  EXPECT_EQ(ground->persons[0].rows[0].y, 1.7F);
  EXPECT_THAT(all_said(*ground), HasSubstr("as heads do"));
  const auto heads = read_as("a.csv", text, {.height = TrackHeight::head});
  ASSERT_TRUE(heads) << heads.error().message;
  EXPECT_EQ(heads->persons[0].rows[0].y, 0.0F);
  EXPECT_NEAR(heads->persons[0].stature, 1.7F, 0.06F);
}

TEST(TrackHeading, IsTheAngleOfADirection) {
  for (int i = 0; i < 3600; ++i) {
    const double angle = (i - 1799.5) * std::numbers::pi / 1800.0;  // from +Z, which is south, towards +X
    for (const double length : {1e-6, 1.0, 12.5}) {
      EXPECT_NEAR(heading_of_direction(length * std::sin(angle), -length * std::cos(angle)), angle, 2e-5);
    }
  }
  EXPECT_TRUE(std::isnan(heading_of_direction(0.0, 0.0)));
}

TEST(TrackNumber, IsTheNearestDoubleToItsText) {
  for (const char* const text :
       {"0", "-0.0", "7.", ".5", "+3.25", "123456789012345678", "1.0683293133551417", "1e3", "-2.647565e+00",
        "0.000001", "99999999999999999999", "18446744073709551617", "4.9e-324"}) {
    double value = 0.0;
    ASSERT_TRUE(is_number_text(text, value)) << text;
    EXPECT_EQ(value, std::strtod(text, nullptr)) << text;
  }
  for (const char* const text : {"", " ", "-", "+-1", "--1", "1e999", "abc", "1x", "1 2", ".", "0x10"}) {
    double value = 0.0;
    EXPECT_FALSE(is_number_text(text, value)) << text;
  }
}

}  // namespace
}  // namespace throng::table_test
