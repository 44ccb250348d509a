#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/commands/inspect/report.h"
#include "engine/base/json/json.h"
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

}  // namespace
}  // namespace throng::app::tracks_report_test
