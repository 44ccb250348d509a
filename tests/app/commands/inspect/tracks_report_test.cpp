#include "app/commands/inspect/tracks_report.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/people/measure/line_counts.h"
#include "engine/base/json/json.h"
#include "tests/app/program_run.h"
#include "tests/app/temporary_folder.h"
#include "tests/tracks/track_file.h"

namespace throng::app::tracks_report_test {
namespace {

using testing::HasSubstr;

Trajectories sample() {
  auto tracks = read_as("a.csv", "id,time,x,y,angle [deg]\n1,0,10,20,90\n1,1,11,20,90\n1,1,11,21,90\n2,0,14,24,0\n");
  EXPECT_TRUE(tracks) << tracks.error().message;
  return *tracks;
}

TEST(TracksReport, SaysForAPersonWhatIsInAFile) {
  const std::string text = tracks_text(sample());
  for (const char* part : {"a.csv: table with a header, 2 people, 3 rows\n", "0.00 to 1.00 s, 1.00 rows a second",
                           "4.0 by 4.0 m: x 10.00 to 14.00, y 20.00 to 24.00", "the file says where people look",
                           "plan    none", "odd: 1 row at a time that has one; first person 1 at 1.00 s\n"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
}

TEST(TracksReport, SaysTheSameAsJson) {
  const auto json = parse_json(tracks_json(sample()));
  ASSERT_TRUE(json) << json.error().message;
  EXPECT_EQ((*json)["people"].get<int>(), 2);
  EXPECT_EQ((*json)["rows"].get<int>(), 3);
  EXPECT_EQ((*json)["extent_m"]["y"].elements()[1].get<double>(), 24.0);
  EXPECT_EQ((*json)["report"].elements()[0]["kind"].get<std::string>(), "duplicate");
  EXPECT_TRUE((*json)["stature_m"].is_null());
  EXPECT_EQ((*json)["plan"]["floors"].get<int>(), 0);
}

class MeasuresOfTracks : public test::TemporaryFolder {
 protected:
  const std::string crossing_ = THRONG_SOURCE_DIR "/assets/samples/crossing.txt";
};

TEST_F(MeasuresOfTracks, AreWrittenOfThePartThatIsNamed) {
  const std::string table = folder_ / "people.csv";
  const ProgramRun run = run_program({"inspect", crossing_, "--measures", table, "--track-part", "6,5"});
  EXPECT_EQ(run.exit_status, 0);
  EXPECT_EQ(run.errors, "throng: wrote " + table + "\n");
  std::ostringstream text;
  text << std::ifstream(table).rdbuf();
  EXPECT_THAT(text.str(), testing::StartsWith("id,frame,time,x,y,speed,density\n1,50,5.000,-2.1220,-1.4310,"));
  EXPECT_THAT(text.str(), HasSubstr("\n1,60,6.000,"));
  EXPECT_EQ(text.str().find("\n1,61,"), std::string::npos);
}

TEST(TracksReport, SaysWhoPassesALine) {
  const LineCounts passed{.to_left = 1200, .to_right = 1, .seconds = 8.0};
  EXPECT_EQ(tracks_text(sample()).find("  line"), std::string::npos);
  EXPECT_THAT(tracks_text(sample(), &passed), HasSubstr("  line    1,200 people to the left and 1 to the right in "
                                                        "8.00 s, 150.000 and 0.125 people a second\n"));
  const LineCounts at_once;
  EXPECT_THAT(tracks_text(sample(), &at_once), HasSubstr(" to the right in 0.00 s\n"));
  const auto json = parse_json(tracks_json(sample(), &passed));
  ASSERT_TRUE(json) << json.error().message;
  EXPECT_EQ((*json)["count_line"]["to_left"].get<int>(), 1200);
  EXPECT_EQ((*json)["count_line"]["to_right_a_second"].get<double>(), 0.125);
}

TEST_F(MeasuresOfTracks, CountTheTwoStreamsOfTheSampleAtALine) {
  const ProgramRun run = run_program({"inspect", crossing_, "--count-line", "0,-3,0,3"});
  EXPECT_EQ(run.exit_status, 0);
  EXPECT_THAT(run.output, HasSubstr("  line    0 people to the left and 12 to the right in 19.70 s, 0.000 and 0.609 "));
}

TEST_F(MeasuresOfTracks, AreRefusedOfAnEmptyPartAndOfAModel) {
  const std::string table = folder_ / "people.csv", model = THRONG_SOURCE_DIR "/assets/samples/robot.glb";
  EXPECT_THAT(run_program({"inspect", crossing_, "--measures", table, "--track-part", "50,60"}).errors,
              HasSubstr("--track-part: " + crossing_ + " has rows from 0.00 to 19.70 s of its clock\n"));
  EXPECT_THAT(run_program({"inspect", model, "--measures", table}).errors, HasSubstr(" is no file of trajectories; "));
  EXPECT_THAT(run_program({"inspect", crossing_, "--cut-off", "1"}).errors,
              HasSubstr("--cut-off: goes with --measures"));
  EXPECT_THAT(run_program({"inspect", model, "--count-line", "0,0,1,0"}).errors,
              HasSubstr("--count-line: " + model + " is no file of trajectories; "));
  EXPECT_THAT(run_program({"inspect", crossing_, "--track-part", "1,2"}).errors,
              HasSubstr("--track-part: goes with --measures or --count-line"));
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

}  // namespace
}  // namespace throng::app::tracks_report_test
