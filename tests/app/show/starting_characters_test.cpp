#include "app/show/starting_characters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/files/exit_status.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::starting_characters_test {
namespace {

TEST(StartingCharacters, AreTheBuiltInOneWhereNoneIsNamed) {
  StartError error;
  const auto cast = load_starting_characters(test::demo("--agents 2"), error);
  ASSERT_TRUE(cast) << error.message;
  ASSERT_EQ(cast->characters.size(), 1U);
  EXPECT_EQ(cast->characters[0].name, "mannequin (built in)");
}

TEST(StartingCharacters, EndTheRunWhereOneCannotBeLoaded) {
  StartError error;
  DemoOptions options = test::demo("--agents 2");
  options.models = {"none.glb"};
  EXPECT_FALSE(load_starting_characters(options, error));
  EXPECT_EQ(error.status, exit_job_failed);
  EXPECT_THAT(error.message, testing::HasSubstr("none.glb"));
}

TEST(StartingCharacters, EndTheRunWhereNoneHasTheChosenClip) {
  StartError error;
  EXPECT_FALSE(load_starting_characters(test::demo("--clips walk=moonwalk"), error));
  EXPECT_EQ(error.status, exit_usage);
  EXPECT_THAT(error.message, testing::HasSubstr("--clips "));
}

const std::string features = THRONG_SOURCE_DIR "/tests/data/features/";

TEST(StartingCharacters, StandAsIsAskedOfEachByName) {
  StartError error;
  const std::string models = features + "plain.glb " + features + "linear-trs.glb";
  const auto cast =
      load_starting_characters(test::demo("--agents 2 " + models + " --scale 3,plain=2 --up linear-trs.glb=z"), error);
  ASSERT_TRUE(cast) << error.message;
  EXPECT_EQ(cast->characters[0].placement.choice, (anim::PlacementChoice{.scale = 2.0}));
  EXPECT_EQ(cast->characters[1].placement.choice, (anim::PlacementChoice{.scale = 3.0, .up = anim::UpAxis::z}));
}

TEST(StartingCharacters, EndTheRunWhereOneIsPlacedThatIsNotThere) {
  StartError error;
  EXPECT_FALSE(load_starting_characters(test::demo("--agents 2 " + features + "plain.glb --up plane=z"), error));
  EXPECT_EQ(error.status, exit_usage);
  EXPECT_EQ(error.message, "--up: no model is called plane; there is plain.glb");
}

}  // namespace
}  // namespace throng::app::starting_characters_test
