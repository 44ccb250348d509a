#include "app/settings/track_values.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::app::track_values_test {
namespace {

using testing::HasSubstr;

TrajectoryOptions all_set() {
  TrajectoryOptions tracks{.file = "walk.csv"};
  tracks.reading = {.fps = 30'000.0 / 1001.0,
                    .times_a_second = 1.0 / 60.0,
                    .metres_a_unit = 0.3048,
                    .up = TrackUp::y,
                    .height = TrackHeight::ground,
                    .angle = TrackAngle::north,
                    .walls = "hall\xff.wkt",
                    .lenient = true};
  tracks.start = 0.1;
  tracks.rate = -0.3;
  tracks.part.emplace(-1.0 / 3.0, 1e9);
  tracks.repeats = false;
  return tracks;
}

TEST(ValuesOfARecordedCrowd, ReadBackAsTheyWereWritten) {
  const Json json = to_json(all_set());
  EXPECT_EQ(json.members().size(), track_values().size()) << json.dump();
  const auto written = parse_json(json.dump());
  ASSERT_TRUE(written);
  TrajectoryOptions read;
  const Complaint wrong = from_json(*written, read);
  EXPECT_FALSE(wrong) << *wrong;
  EXPECT_EQ(read, all_set());
}

TEST(ValuesOfARecordedCrowd, AreLeftOutWhereTheFileSaysThem) {
  EXPECT_EQ(to_json(TrajectoryOptions{.file = "walk.csv"}).dump(), R"({"file":"walk.csv"})");
}

TEST(ValuesOfARecordedCrowd, AreRefusedByKey) {
  const auto refusal = [](const char* text) {
    TrajectoryOptions tracks;
    return from_json(*parse_json(text), tracks).value_or("(taken)");
  };
  EXPECT_EQ(refusal(R"({"fps": 25})"), "\"file\" is missing");
  EXPECT_EQ(refusal(R"({"file": 3})"), "\"file\" must be the name of a file");
  EXPECT_EQ(refusal(R"({"file": "a.csv", "rate": 0})"), "\"rate\" must be a number, -100 to 100, and not 0");
  EXPECT_EQ(refusal(R"({"file": "a.csv", "lenient": 1})"), "\"lenient\" must be on or off");
  EXPECT_THAT(refusal(R"({"file": "a.csv", "speed": 1})"),
              HasSubstr("unknown key \"speed\"; it knows file, walls, fps"));
  EXPECT_EQ(refusal("[]"), "must be an object with a \"file\"");
}

}  // namespace
}  // namespace throng::app::track_values_test
