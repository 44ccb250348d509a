#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tracks/track_file.h"

namespace throng::tracks_test {
namespace {

using testing::HasSubstr;

constexpr const char* header = "id,time,x,y\n";

TEST(Tracks, AscendInTimeAndTheLastOfDuplicatesCounts) {
  const auto tracks = read_as("a.csv", std::string(header) + "b,3,0,0\na,2,5,0\na,-1,4,0\na,2,6,0\na,1,4.5,0\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  ASSERT_EQ(tracks->persons.size(), 2U);
  EXPECT_EQ(tracks->persons[0].id, "a");  // came first
  const auto& rows = tracks->persons[0].rows;
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].seconds, -1.0);
  EXPECT_EQ(file_place(*tracks, rows[2]).x, 6.0);
  EXPECT_EQ(found(*tracks, TrackOddity::duplicate), 1U);
  EXPECT_EQ(tracks->first_seconds, -1.0);
  EXPECT_EQ(tracks->last_seconds, 3.0);
}

TEST(Tracks, LieWithinATenthOfAMillimetreInATownFarFromTheMiddleOfTheWorld) {
  const auto tracks =
      read_as("a.csv", std::string(header) + "1,0,5000000.1234,3000000.5678\n2,0,5002000.4321,3001000.8765\n");
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_EQ(tracks->origin, glm::dvec2(5001000.0, 3000501.0));
  EXPECT_NEAR(file_place(*tracks, tracks->persons[0].rows[0]).x, 5000000.1234, 1e-4);
  EXPECT_NEAR(file_place(*tracks, tracks->persons[1].rows[0]).y, 3001000.8765, 1e-4);
}

TEST(Tracks, ReportGapsTeleportsAndOverlaps) {
  std::string text = header;
  for (int i = 0; i < 40; ++i) {
    const std::string time = std::to_string(i * 0.1);
    if (i < 10 || i > 20) text += "gap," + time + "," + std::to_string(i * 0.1) + ",0\n";
    text += "jump," + time + "," + (i < 5 ? "0" : "9") + ",5\n";
    text += "one," + time + ",20,20\ntwo," + time + ",20.05," + (i > 30 ? "20.05" : "22") + "\n";
  }
  const auto tracks = read_as("a.csv", text);
  ASSERT_TRUE(tracks) << tracks.error().message;
  ASSERT_EQ(tracks->report.found.size(), 3U);
  EXPECT_EQ(tracks->report.found[0].oddity, TrackOddity::gap);
  EXPECT_EQ(tracks->report.found[0].count, 1U);
  EXPECT_EQ(tracks->report.found[0].first, "person gap at 0.90 s: no row for 1.20 s");
  EXPECT_EQ(tracks->report.found[1].oddity, TrackOddity::teleport);
  EXPECT_EQ(tracks->report.found[1].first, "person jump at 0.50 s: 9.0 m in 0.10 s");
  EXPECT_EQ(tracks->report.found[2].oddity, TrackOddity::overlap);
  EXPECT_EQ(tracks->report.found[2].count, 1U);  // a pair, however long
  EXPECT_EQ(tracks->report.found[2].first, "persons one and two at 3.10 s");
}

TEST(Tracks, FindAllOverlapsThatComparingEachWithEachFinds) {
  std::string text = header;
  std::vector<glm::dvec2> places;
  std::uint32_t state = 7;
  const auto random = [&] { return static_cast<double>((state = state * 1664525U + 1013904223U) >> 8U) / (1U << 24U); };
  for (int i = 0; i < 1500; ++i) {
    places.emplace_back(std::floor(random() * 3000.0) / 1000.0, std::floor(random() * 3000.0) / 1000.0);
    text += std::to_string(i) + ",0," + std::to_string(places.back().x) + "," + std::to_string(places.back().y) + "\n";
  }
  std::size_t pairs = 0, unsure = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double distance = std::hypot(places[i].x - places[j].x, places[i].y - places[j].y);
      if (distance < 0.1) ++pairs;
      if (std::abs(distance - 0.1) < 1e-6) ++unsure;
    }
  }
  const auto tracks = read_as("a.csv", text);
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_NEAR(static_cast<double>(found(*tracks, TrackOddity::overlap)), static_cast<double>(pairs),
              static_cast<double>(unsure));
  EXPECT_GT(pairs, 1000U);
}

TEST(Tracks, LookForOverlapsOfACrowdOnOnePointWithoutEnd) {
  std::string text = header;
  for (int i = 0; i < 20'000; ++i) text += std::to_string(i) + ",0,1,1\n";
  const auto tracks = read_as("a.csv", text);  // 200 million pairs
  ASSERT_TRUE(tracks) << tracks.error().message;
  EXPECT_GT(found(*tracks, TrackOddity::overlap), 100'000U);
}

TEST(Tracks, AreTheSameReadInBlocksOnTwoThreads) {
  std::string text = header;
  for (int i = 0; i < 200'000; ++i) {
    text += "p" + std::to_string(i % 1000) + "," + std::to_string(i / 1000) + "," + std::to_string(i % 97) + ".25," +
            std::to_string(i % 89) + "\n";
  }
  std::vector<double> shares;
  const TrackFolder folder;
  const auto tracks = read_trajectories(folder.file("a.csv", text), {}, [&](double share) { shares.push_back(share); });
  ASSERT_TRUE(tracks) << tracks.error().message;
  ASSERT_EQ(tracks->persons.size(), 1000U);
  for (std::size_t p = 0; p < 1000; ++p) {
    EXPECT_EQ(tracks->persons[p].id, "p" + std::to_string(p));
    ASSERT_EQ(tracks->persons[p].rows.size(), 200U);
    for (std::size_t k = 0; k < 200; ++k) {
      const std::size_t i = k * 1000 + p;
      ASSERT_EQ(tracks->persons[p].rows[k].seconds, static_cast<double>(k));
      ASSERT_EQ(file_place(*tracks, tracks->persons[p].rows[k]),
                glm::dvec2(static_cast<double>(i % 97) + 0.25, static_cast<double>(i % 89)));
    }
  }
  ASSERT_FALSE(shares.empty());
  EXPECT_EQ(shares.back(), 1.0);
}

TEST(Tracks, AreToldFromModels) {
  const TrackFolder folder;
  EXPECT_TRUE(looks_like_trajectories(folder.file("a", "id,time,x,y\n1,0,0,0\n")));
  EXPECT_TRUE(looks_like_trajectories(folder.file("b.csv", "who,when\n")));
  EXPECT_TRUE(looks_like_trajectories(folder.file("c", "{\"track\": {\"f\": 1, \"p\": 1, \"x\": 1, \"y\": 1}}\n")));
  EXPECT_FALSE(looks_like_trajectories(folder.file("d.gltf", "{\"asset\": {\"version\": \"2.0\"}}")));
  EXPECT_FALSE(looks_like_trajectories(folder.file("e.gltf", "{\n \"asset\": {\"version\": \"2.0\"}}")));
  EXPECT_FALSE(looks_like_trajectories(THRONG_SOURCE_DIR "/assets/mannequin.glb"));
  EXPECT_FALSE(looks_like_trajectories(folder.path("none")));
}

}  // namespace
}  // namespace throng::tracks_test
