#include "app/show/starting_characters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/files/exit_status.h"
#include "tests/app/recording/recorded_run.h"

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

}  // namespace
}  // namespace throng::app::starting_characters_test
