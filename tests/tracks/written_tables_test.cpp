#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tracks/track_file.h"

namespace throng::written_tables_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// What people and their programs write, in all its forms: it is read as the plain table is, or refused in a line.
TEST(WrittenTable, HasRowsAsWideAsItsHeader) {
  EXPECT_EQ(
      error_of("a.csv", "id,frame,x,y,v\n1,0,-4,0000,1,5000,1,3\n"),
      "a.csv: line 2: it goes on after its 5 columns; name each column, write numbers with a point, and names with "
      "a comma in quotes, or skip such rows with --lenient");
  EXPECT_THAT(error_of("a.txt", "\"id\" \"frame\" \"x\" \"y\" \"speed\"\n\"1\" 1 0 -4.0 1.5 1.3\n"),
              StartsWith("a.txt: line 2: it goes on after its 5 columns"));
  EXPECT_THAT(error_of("a.csv", "id,frame,x,y,v,w\n1,0,1,2,1.3\n"),
              StartsWith("a.csv: line 2: it has 5 columns, but w is column 6; put what is missing there"));
  EXPECT_THAT(error_of("a.csv", "id,frame,x,y,v\n1,0,1,2\n"), StartsWith("a.csv: line 2: it has 4 columns, but v is"));
  EXPECT_EQ(error_of("a.csv", "id,frame,x,y,v\n1,0,1,2,\n1,1,1,2,3,\n1,2,1,2, # note\n"), "");
  EXPECT_EQ(error_of("a.txt", "id frame x y v\n1 0 1 2 3\n1 1 1 2 3  \n"), "");
}

TEST(WrittenTable, MayHaveDecimalCommasBetweenOtherSeparators) {
  for (const char* const text :
       {"id;time;x;y\n1;0;-1,5;2\n1;0,5;-1,25;2,75\n", "sep=;\nid;time;x;y\n1;0;-1,5;2\n1;0,5;-1,25;2,75\n",
        "id\ttime\tx\ty\n1\t0\t-1,5\t2\n1\t0,5\t-1,25\t2,75\n",
        "id,time,x,y\n1,0,\"-1,5\",2\n1,\"0,5\",\"-1,25\",\"2,75\"\n"}) {
    const auto tracks = read_as("a.csv", text);
    ASSERT_TRUE(tracks) << tracks.error().message;
    ASSERT_EQ(tracks->row_count, 2U) << text;
    EXPECT_EQ(tracks->persons[0].rows[1].seconds, 0.5);
    EXPECT_EQ(file_place(*tracks, tracks->persons[0].rows[1]), glm::dvec2(-1.25, 2.75));
  }
}

TEST(WrittenTable, MayHaveCommentsOfMatlabAndC) {
  const auto tracks = read_as("a.txt", "% by Matlab\n// and C\nid time x y\n1 0 1 2\n% more\n1 1 1 2\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->row_count, 2U);
}

TEST(WrittenTable, MayWriteIdsAsFractions) {
  const auto tracks = read_as("a.csv", "id,time,x,y\n1,0,1,2\n1.0,1,1,2\n1.000e+00,2,1,2\n007,0,5,5\n1.5,0,9,9\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  ASSERT_EQ(tracks->persons.size(), 3U);
  EXPECT_EQ(tracks->persons[0].id, "1");
  EXPECT_EQ(tracks->persons[0].rows.size(), 3U);
  EXPECT_EQ(tracks->persons[1].id, "007");
  EXPECT_EQ(tracks->persons[2].id, "1.5");
}

TEST(WrittenTable, MayHaveQuotesInAnId) {
  const auto tracks = read_as("a.csv", "id,time,x,y\n\"Ann \"\"A, B\"\"\",0,1,2\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->persons[0].id, "Ann \"A, B\"");
}

TEST(WrittenTable, MayWriteTimesAsAClockShowsThem) {
  for (const char* const text :
       {"id,time,x,y\n1,00:59:59,1,2\n1,01:00:00.5,1,2\n", "id;time;x;y\n1;00:59:59,0;1;2\n1;01:00:00,5;1;2\n",
        "id,time,x,y\n1,2026-02-28T23:59:59Z,1,2\n1,2026-03-01 00:00:00.5+01:00,1,2\n",
        "id;timestamp;x;y\n1;1999-12-31T23:59:59.000;1;2\n1;2000-01-01T00:00:00.500;1;2\n"}) {
    const auto tracks = read_as("a.csv", text);
    ASSERT_TRUE(tracks) << tracks.error().message;
    EXPECT_EQ(tracks->persons[0].rows[1].seconds - tracks->persons[0].rows[0].seconds, 1.5) << text;
  }
  for (const char* const wrong :
       {"1:2", "1:60:00", "1:00:99", "2026-02-30T00:00:00", "a:b:c", "1:2:", "-1:00:00", "2026-1T1:1:1"}) {
    EXPECT_THAT(error_of("a.csv", std::string("id,time,x,y\n1,") + wrong + ",1,2\n"),
                HasSubstr("put the time in seconds"))
        << wrong;
  }
}

TEST(WrittenTable, TakesFramesWhereTimesAreRounded) {
  for (const char* const header : {"id,frame,time,x,y\n", "id,frame,time [ms],x,y\n"}) {
    const int times_a_second = std::string(header).find("ms") == std::string::npos ? 1 : 1000;
    std::string text = header;
    for (int frame = 0; frame < 60; ++frame) {
      text += "1," + std::to_string(frame) + "," + std::to_string((frame + 5) / 10 * times_a_second) + "," +
              std::to_string(0.13 * frame) + ",2\n";
    }
    const auto tracks = read_as("a.csv", text);
    ASSERT_TRUE(tracks) << tracks.error().message;
    EXPECT_EQ(tracks->rows_a_second, 10.0);
    EXPECT_EQ(tracks->row_count, 60U);
    EXPECT_THAT(all_said(*tracks), HasSubstr("Times are rounded: several rows of a person have one \"time"));
  }
}

TEST(WrittenTable, MustHaveOneUnitForAllAxes) {
  EXPECT_THAT(error_of("a.csv", "id,t,x [m],y [cm]\n1,0,1,100\n"),
              HasSubstr("\"x [m]\" is in m, and \"y [cm]\" in cm; write both in one unit"));
  EXPECT_THAT(error_of("a.csv", "id,t,x [m],y [m],z/mm\n1,0,1,1,100\n"), HasSubstr("and \"z/mm\" in mm"));
  EXPECT_EQ(error_of("a.csv", "id,t,x [cm],y\n1,0,1,1\n"), "");
}

TEST(WrittenTable, MustHaveEndsOfLinesThatOthersRead) {
  EXPECT_THAT(error_of("a.csv", "id,t,x,y\r1,0,1,1\r1,1,1,1\r"),
              HasSubstr("its lines end with a carriage return alone"));
}

TEST(WrittenTable, MustNameItsColumnsWhereRowsHaveALabel) {
  EXPECT_THAT(error_of("annotations.txt",
                       "0 100 200 140 290 0 0 0 0 \"Pedestrian\"\n0 101 200 141 290 12 0 0 0 \"Pedestrian\"\n"),
              HasSubstr("rows of 10 columns without a header; put a line before them"));
}

TEST(WrittenTable, OfSumoHasAnglesClockwiseFromNorth) {
  const auto tracks =
      read_as("fcd.csv",
              "time;id;x;y;angle;type;speed;pos;lane;edge;slope\n0;p;0;0;90;T;1.3;3;;e;0\n1;p;1;0;90;T;1.3;3;;e;0\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->format, "SUMO FCD table");
  EXPECT_NEAR(tracks->persons[0].rows[0].heading, 1.5707963, 1e-6);  // east
}

TEST(WrittenTable, OfVadereHasAnyNumberOfProcessor) {
  const auto tracks =
      read_as("postvis.traj",
              "pedestrianId simTime endTime-PID5 startX-PID5 startY-PID5 endX-PID5 endY-PID5 targetId-PID6\n"
              "1 0.0 0.5 0.0 1.5 0.65 1.5 3\n1 0.5 1.0 0.65 1.5 1.3 1.5 3\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->format, "Vadere");
  EXPECT_EQ(tracks->last_seconds, 1.0);
}

TEST(WrittenTable, OfVadereNeedsNoScenarioThatIsBroken) {
  const TrackFolder folder;
  folder.file("other.scenario", "{\"name\": \"half");
  const auto tracks = read_trajectories(
      folder.file("postvis.traj",
                  "pedestrianId simTime endTime-PID1 startX-PID1 startY-PID1 endX-PID1 endY-PID1\n1 0 0.5 0 1 0.5 1\n"),
      {});
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_THAT(all_said(*tracks), HasSubstr("other.scenario is left out: its text "));
}

TEST(WrittenTable, OfVadereHasRoundThings) {
  const TrackFolder folder;
  folder.file(
      "a.scenario",
      R"({"scenario": {"topography": {"obstacles": [{"shape": {"type": "CIRCLE", "radius": 2, "center": {"x": 6, "y": 3}}}],
                  "targets": [{"shape": {"type": "CIRCLE", "radius": 1, "center": {"x": 1, "y": 3}}}]}}})");
  const auto tracks = read_trajectories(
      folder.file("a.traj",
                  "pedestrianId simTime endTime-PID1 startX-PID1 startY-PID1 endX-PID1 endY-PID1\n1 0 0.5 0 1 0.5 1\n"),
      {});
  ASSERT_TRUE(tracks) << tracks.error().message;
  ASSERT_EQ(tracks->plan.obstacles.size(), 1U);
  EXPECT_EQ(tracks->plan.exits.size(), 1U);
  for (const glm::vec2& corner : tracks->plan.obstacles[0]) {
    const glm::dvec2 place(tracks->origin.x + static_cast<double>(corner.x),
                           tracks->origin.y - static_cast<double>(corner.y));
    EXPECT_NEAR(std::hypot(place.x - 6.0, place.y - 3.0), 2.0, 1e-5);
  }
}

}  // namespace
}  // namespace throng::written_tables_test
