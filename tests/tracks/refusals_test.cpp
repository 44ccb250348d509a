#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tracks/track_file.h"

namespace throng::refusals_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* header = "id,time,x,y\n";

std::string table_error(const std::string& rows) { return error_of("a.csv", header + rows); }

TEST(TrackRefusals, NameFileLineAndRemedyOfABadRow) {
  EXPECT_EQ(table_error("1,0,0,0\n1,1,abc,0\n"),
            "a.csv: line 3: \"abc\" is not a number; put x in metres there, or skip such rows with --lenient");
  EXPECT_THAT(table_error("1,0,nan,0\n"), HasSubstr("line 2: \"nan\" is not finite; put x in metres there"));
  EXPECT_THAT(table_error("1,0,0,-inf\n"), HasSubstr("\"-inf\" is not finite; put y in metres there"));
  EXPECT_THAT(table_error("1,soon,0,0\n"), HasSubstr("\"soon\" is not a number; put the time in seconds there"));
  EXPECT_THAT(table_error("1,0,,0\n"), HasSubstr("an empty cell is no number; put x in metres there"));
  EXPECT_THAT(table_error(",0,0,0\n"), HasSubstr("the person's id is empty; put one there"));
  EXPECT_THAT(table_error("1,0,0\n"), HasSubstr("it has 3 columns, but y is column 4; put what is missing there"));
  EXPECT_THAT(table_error("1,0,1e8,0\n"), HasSubstr("more than 10,000 km off; put metres there"));
  EXPECT_THAT(table_error("1,1e300,0,0\n"), HasSubstr("its time is thousands of years off"));
  EXPECT_THAT(table_error("1,0,1e999,0\n"), HasSubstr("\"1e999\" is not a number"));
  EXPECT_THAT(error_of("a.csv", "id;time;x;y\n1;0;1,500.5;0\n"), HasSubstr("with a point instead of the comma"));
  EXPECT_THAT(table_error("1,0," + std::string(100, 'x') + ",0\n"), HasSubstr("\"" + std::string(40, 'x') + "...\""));
  EXPECT_THAT(table_error("1,0,1,5,0,5\n"),
              HasSubstr("it goes on after its 4 columns; name each column, write numbers with a point"));
}

TEST(TrackRefusals, SkipAndCountBadRowsWhereTheyMay) {
  const auto tracks = read_as("a.csv", std::string(header) + "1,0,0,0\n1,1,abc,0\n1,2,0\n1,3,1,1\n", {.lenient = true});
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->row_count, 2U);
  EXPECT_EQ(found(*tracks, TrackOddity::bad_row), 2U);
  EXPECT_EQ(tracks->report.found[0].first, "line 3: \"abc\" is not a number; put x in metres there");
  EXPECT_THAT(error_of("a.csv", std::string(header) + "1,1,abc,0\n", {.lenient = true}),
              HasSubstr("every row is wrong, the first line 2: \"abc\" is not a number"));
}

TEST(TrackRefusals, NameTheLineOfABadRowFarDownInALargeFile) {
  std::string text = header;
  for (int i = 0; i < 300'000; ++i) {
    text += std::to_string(i % 50) + "," + std::to_string(i / 50) + "," + (i == 251'234 ? "?" : "1.5") + ",2.5\n";
  }
  text += "1,zzz,0,0\n";
  EXPECT_THAT(error_of("a.csv", text), StartsWith("a.csv: line 251236: \"?\" is not a number"));
}

TEST(TrackRefusals, SayWhatIsNoTextOfRows) {
  EXPECT_THAT(error_of("a.csv", ""), HasSubstr("a.csv: it is empty; name a file with rows"));
  EXPECT_THAT(error_of("a.csv", "\n\n# nothing\n"), HasSubstr("it has no rows"));
  EXPECT_THAT(error_of("a.csv", header), HasSubstr("it has no rows; name a file with some"));
  EXPECT_THAT(error_of("a.csv", std::string("\xFF\xFEi\0d\0", 6)), HasSubstr("it is UTF-16; save it as UTF-8"));
  EXPECT_THAT(error_of("a.csv", std::string("i\0d\0,\0t\0", 8)), HasSubstr("it is UTF-16; save it as UTF-8"));
  EXPECT_THAT(error_of("a.csv", std::string("\x1F\x8B\x08", 3)), HasSubstr("unpack it with gunzip"));
  EXPECT_THAT(error_of("a.csv", std::string("PK\x03\x04") + "..."), HasSubstr("save it as CSV"));
  EXPECT_THAT(error_of("a.csv", std::string("\x7F"
                                            "ELF\x02\x01\0\0\0\0",
                                            10)),
              HasSubstr("it is no text and no database"));
  EXPECT_THAT(error_of("a.csv", "1,2,3\n4,5,6\n"), HasSubstr("line 1: rows of 3 columns without a header; put a line"));
  EXPECT_THAT(error_of("a.csv", "1 2 3 4 5 6\n"), HasSubstr("rows of 6 columns without a header"));
  EXPECT_THAT(error_of("a.csv", std::string(100'000, 'x')), HasSubstr("line 1: it is longer than 64 KiB"));
  EXPECT_THAT(error_of("a.csv", header + std::string(3'000'000, '1')), HasSubstr("line 2: it is longer than 1 MiB"));
  const TrackFolder folder;
  EXPECT_THAT(read_trajectories(folder.path("none.csv"), {}).error().message, HasSubstr("there is no such file"));
  EXPECT_THAT(read_trajectories(folder.path(""), {}).error().message, HasSubstr("it is a folder"));
}

TEST(TrackRefusals, SayWhatIsWrongWithOtherFormats) {
  EXPECT_THAT(
      error_of("a.txt", "1 0 0 0 1.7\n1 1 0 zero 1.7\n"),
      HasSubstr("a.txt: line 2: \"zero\" is not a number; put y in metres there, or skip such rows with --lenient"));
  EXPECT_THAT(error_of("a.txt", "1 0 0 0 1.7\n1 1 0.5m 0 1.7\n"), HasSubstr("line 2: \"0.5m\" is not a number"));
  EXPECT_THAT(error_of("a.txt", "1 0 0 0 1.7\n1 1 0\n"), HasSubstr("it has 3 columns, but z is column 5"));
  EXPECT_THAT(error_of("o.txt", "1 1 0 0 0 1 0 0\n1 x1 y 0 0 1 0 0\n"), HasSubstr("line 2: \"y\" is not a number"));
  EXPECT_THAT(error_of("fcd.csv", "timestep_time;person_id;vehicle_x;person_y\n0;a;1;2\n"),
              HasSubstr("of which none is x (posx, xpos, positionx, ...); name them so"));
  EXPECT_THAT(error_of("a.ndjson", "{\"track\": {\"f\": 1, \"p\": 1, \"x\": 1, \"y\": 1}}\n{\"track\": {\"f\": 1\n"),
              HasSubstr("a.ndjson: line 2: it is no JSON object; put one there"));
  EXPECT_EQ(error_of("a.json", "{\n  \"0\": {\n"), "a.json: its text is not JSON at line 3, column 1; export it again");
  EXPECT_THAT(error_of("a.ndjson", "{\"track\": {\"f\": 1, \"p\": 1, \"x\": \"a\", \"y\": 1}}\n"),
              HasSubstr("line 1: \"a\" is not a number; put x there"));
  EXPECT_THAT(error_of("a.ndjson", "{\"track\": {\"f\": 1, \"x\": 1, \"y\": 1}}\n"), HasSubstr("it has no id"));
  EXPECT_THAT(error_of("a.ndjson", "{\"track\": {\"f\": 1, \"p\": 2, \"x\": 1}}\n"), HasSubstr("it has no y; add it"));
  EXPECT_THAT(
      error_of("v.traj", "pedestrianId simTime endTime-PID1 startX-PID1 startY-PID1 endX-PID1 endY-PID1\n1 0 1 2\n"),
      HasSubstr("v.traj: line 2: it has 4 columns, but endY-PID1 is column 7"));
}

TEST(TrackRefusals, SayWhatIsWrongWithXml) {
  const std::string start = "<fcd-export>\n<timestep time=\"0\">\n";
  EXPECT_THAT(error_of("a.xml", start + "<person id=\"a\" x=\"1\" y=\"2\"/>"),
              StartsWith("a.xml: line 3: it is no whole XML (no element found); let SUMO write it to its end"));
  EXPECT_THAT(error_of("a.xml", start + "<person id=\"a\" x=\"one\" y=\"2\"/></timestep></fcd-export>"),
              HasSubstr("line 3: \"one\" is not a number; put x there, or skip such rows with --lenient"));
  EXPECT_THAT(error_of("a.xml", start + "<person x=\"1\" y=\"2\"/></timestep></fcd-export>"),
              HasSubstr("it has no id"));
  EXPECT_THAT(error_of("a.xml", "<fcd-export>\n<timestep>\n</timestep></fcd-export>"),
              HasSubstr("line 2: it has no time"));
  EXPECT_THAT(error_of("a.xml", "<routes>\n</routes>"), HasSubstr("<routes> is not what SUMO calls trajectories"));
  EXPECT_THAT(error_of("a.xml", "<fcd-export>\n</fcd-export>"), HasSubstr("it has no rows"));
  EXPECT_THAT(error_of("a.xml", "<fcd-export></timestep>"), HasSubstr("it is no whole XML (mismatched tag)"));
  const std::string bomb = "<!DOCTYPE a [<!ENTITY a \"aaaaaaaaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;\">]>";
  EXPECT_THAT(error_of("a.xml", bomb + start + "</timestep></fcd-export>"), HasSubstr("it has a DOCTYPE"));
  const auto lenient = read_as("a.xml",
                               start +
                                   "<person id=\"a\" x=\"one\" y=\"2\"/><person id=\"a\" x=\"1\" y=\"2\"/></timestep>"
                                   "</fcd-export>",
                               {.lenient = true});
  ASSERT_TRUE(lenient) << lenient.error().message;
  EXPECT_EQ(found(*lenient, TrackOddity::bad_row), 1U);
}

TEST(TrackRefusals, LimitPeopleAndWidth) {
  std::string many = header;
  for (int i = 0; i < 100'001; ++i) many += std::to_string(i) + ",0,1,1\n";
  EXPECT_THAT(error_of("a.csv", many), HasSubstr("more than 100,000 people; cut it into parts"));
  EXPECT_THAT(table_error("1,0,0,0\n2,0,0,12000\n"),
              HasSubstr("its people are up to 12.0 km apart, and 10 km is the most"));
  EXPECT_TRUE(read_as("a.csv", std::string(header) + "1,0,0,0\n2,0,0,12000\n", {.metres_a_unit = 0.01}));
}

}  // namespace
}  // namespace throng::refusals_test
