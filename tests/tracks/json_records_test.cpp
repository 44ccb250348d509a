#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tracks/track_file.h"

namespace throng::json_records_test {
namespace {

using testing::HasSubstr;

// All of these are two people at two times.
TEST(JsonRecords, AreReadInAnyNesting) {
  for (const char* const text : {R"json(
      [{"id": 1, "time": 0, "x": 1, "y": 2}, {"id": 2, "time": 0, "x": 5, "y": 2},
       {"id": 1, "time": 0.5, "x": 1.5, "y": 2}, {"id": 2, "time": "00:00:00.5", "x": "5.5", "y": 2}])json",
                                 R"json(
      {"people": [
        {"id": 1, "name": "Ann", "way": [{"time": 0, "x": 1, "y": 2}, {"time": 0.5, "x": 1.5, "y": 2}]},
        {"id": 2, "way": [{"time": 0, "x": 5, "y": 2}, {"time": 0.5, "x": 5.5, "y": 2}]}]})json",
                                 R"json({
      "steps": [
        {"people": [{"id": 1, "x": 1, "y": 2}, {"id": 2, "x": 5, "y": 2}], "time": 0},
        {"time": 0.5, "people": [{"id": 1, "x": 1.5, "y": 2}, {"id": 2, "x": 5.5, "y": 2}]}
      ]
    })json",
                                 R"json(
      [[{"id": 1, "t(s)": 0, "position": {"x": 1, "y": 2}}, {"id": 2, "t(s)": 0, "position": {"x": 5, "y": 2}}],
       [{"id": 1, "t(s)": 0.5, "place": {"x": 1.5, "y": 2}}, {"id": 2, "t(s)": 0.5, "place": {"x": 5.5, "y": 2}}]])json"}) {
    const auto tracks = read_as("a.json", text);
    ASSERT_TRUE(tracks) << tracks.error().message << "\n" << text;
    EXPECT_EQ(tracks->format, "JSON records");
    ASSERT_EQ(tracks->persons.size(), 2U) << text;
    EXPECT_EQ(tracks->persons[0].id, "1");
    ASSERT_EQ(tracks->persons[1].rows.size(), 2U) << text;
    EXPECT_EQ(tracks->persons[1].rows[1].seconds, 0.5);
    EXPECT_EQ(file_place(*tracks, tracks->persons[1].rows[1]), glm::dvec2(5.5, 2.0));
  }
}

TEST(JsonRecords, HaveTheUnitsOfTheirNames) {
  const auto tracks = read_as("a.json", R"json([{"id": 1, "t(ms)": 500, "x(cm)": 100, "y(cm)": 0},
                                                {"id": 1, "t(ms)": 600, "x(cm)": 113, "y(cm)": 0}])json");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->first_seconds, 0.5);
  EXPECT_NEAR(file_place(*tracks, tracks->persons[0].rows[1]).x, 1.13, 1e-6);
}

TEST(JsonRecords, AreRefusedByTheirNumber) {
  EXPECT_EQ(error_of("a.json", R"([{"id":1,"time":0,"x":1,"y":2},{"time":0,"x":1,"y":2}])"),
            "a.json: record 2: it has no id of a person; add \"id\", or skip such rows with --lenient");
  EXPECT_THAT(error_of("a.json", R"([{"id":1,"time":0,"x":1,"y":"b"}])"),
              HasSubstr("record 1: \"b\" is no number; put y there"));
  EXPECT_THAT(error_of("a.json", R"({"columns": ["id", "x"], "data": [[1, 2]]})"),
              HasSubstr("it is JSON without an object that has x and y; name them so"));
  EXPECT_THAT(error_of("a.json", "[" + std::string(40'000, '[')), HasSubstr("a.json: its text"));
  const auto tracks = read_as("a.json", R"([{"id":1,"time":0,"x":1,"y":2},{"time":0,"x":1,"y":2}])", {.lenient = true});
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(found(*tracks, TrackOddity::bad_row), 1U);
}

TEST(JsonRecords, AreToldFromOtherFilesOfJson) {
  const TrackFolder folder;
  EXPECT_TRUE(looks_like_trajectories(folder.file("a.json", R"([{"id":1,"time":0,"x":1,"y":2}])")));
  EXPECT_TRUE(looks_like_trajectories(folder.file("b.json", "{\n\"rows\": [{\"id\":1,\"time\":0,\"x\":1,\"y\":2}]}")));
  EXPECT_FALSE(looks_like_trajectories(folder.file("c.gltf", "{\n\"asset\": {\"version\": \"2.0\"}}")));
  EXPECT_FALSE(looks_like_trajectories(folder.file("d.throng", "{\n\"version\": 1, \"tuning\": {\"agents\": 10}}")));
}

}  // namespace
}  // namespace throng::json_records_test
