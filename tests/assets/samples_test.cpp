#include "assets/samples/samples.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "throng/throng.h"

#include "engine/base/files/input_file.h"
#include "engine/tracks/read.h"
#include "tests/assets/character_file.h"
#include "tests/assets/rounded_file.h"

namespace throng::test::samples_test {
namespace {

std::string sample(const std::string& name) { return THRONG_SOURCE_DIR "/assets/samples/" + name; }

std::string text_of(const std::string& name) {
  const auto text = read_text(sample(name), "a sample", 1 << 20);
  return text ? *text : text.error().message;
}

TEST(Samples, AreWhatTheirProgramWrites) {
  expect_rounded_alike(samples::make_robot(), "samples/robot.glb");
  EXPECT_EQ(samples::make_crossing(), text_of("crossing.txt"));
  EXPECT_EQ(samples::crossing_floor(), text_of("crossing.wkt"));
}

TEST(Samples, RobotIsReadWithoutANoteAndHasItsFourClips) {
  const auto file = load(sample("robot.glb"));
  ASSERT_TRUE(file);
  EXPECT_TRUE(file->notes.empty());
  ASSERT_EQ(file->characters.size(), 1U);
  EXPECT_EQ(file->characters.front().clip_count(), 4U);
  EXPECT_LT(std::filesystem::file_size(sample("robot.glb")), 200'000U);
}

TEST(Samples, CrossingIsReadWithItsFloorAndNothingInItIsOdd) {
  const auto tracks = read_trajectories(sample("crossing.txt"), {});
  ASSERT_TRUE(tracks);
  EXPECT_EQ(tracks->persons.size(), 24U);
  EXPECT_EQ(tracks->plan.floors.size(), 1U);
  EXPECT_TRUE(tracks->report.found.empty());
}

}  // namespace
}  // namespace throng::test::samples_test
