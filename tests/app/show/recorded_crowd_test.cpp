// A recorded crowd that takes the place of another crowd.
#include <memory>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"
#include "tests/app/temporary_folder.h"
#include "tests/tracks/track_file.h"

namespace throng::app::recorded_crowd_test {
namespace {

using test::demo;
using test::show_of;
using test::sixtieth;
using testing::HasSubstr;

std::shared_ptr<const Trajectories> people(int count) {
  std::string text = "id,time,x,y\n";
  for (int person = 0; person < count; ++person) {
    for (int row = 0; row < 5; ++row) {
      text += std::to_string(person) + "," + std::to_string(row) + "," + std::to_string(row) + "," +
              std::to_string(person) + "\n";
    }
  }
  auto read = read_as("people.csv", text);
  return std::make_shared<const Trajectories>(std::move(*read));
}

TEST(ReplacedTrajectories, TakeThePlaceOfEverybodyAndOfEachOther) {
  const auto show = show_of(demo("--agents 12"));
  show->animate(sixtieth);
  for (const int count : {7, 3}) {
    ASSERT_TRUE(show->replace_trajectories(people(count)));
    show->animate(sixtieth);
    EXPECT_EQ(show->stage().tuning().scene, Scene::tracks);
    EXPECT_EQ(show->stage().crowd().size(), static_cast<std::size_t>(count));
    EXPECT_TRUE(show->stage().crowd().tracks()->clock().repeats);
    EXPECT_THAT(show->notice(), HasSubstr(std::to_string(count) + " people"));
  }
  test::change(*show, [](Tuning& tuning) { tuning.scene = Scene::plaza; });
  EXPECT_EQ(show->stage().crowd().tracks(), nullptr);
}

TEST(ReplacedTrajectories, GoOnAtTheirMomentWithOtherCharacters) {
  const auto show = show_of(demo("--agents 12"));
  ASSERT_TRUE(show->replace_trajectories(people(7)));
  for (int frame = 0; frame < 60; ++frame) show->animate(sixtieth);
  const TrackClock before = show->stage().crowd().tracks()->clock();
  const std::string model = std::string(THRONG_SOURCE_DIR) + "/tests/data/features/plain.glb";
  ASSERT_TRUE(show->take(LoadModels{{model}}));
  EXPECT_EQ(show->stage().crowd().tracks()->clock(), before);
}

using ReplacedWhileRecording = test::TemporaryFolder;

TEST_F(ReplacedWhileRecording, AreRefusedAndARecordedCrowdIsNotRecorded) {
  const auto show = show_of(demo("--agents 12"));
  ASSERT_TRUE(show->start_recording(folder_ / "run.rec"));
  const Status replaced = show->replace_trajectories(people(7));
  ASSERT_FALSE(replaced);
  EXPECT_THAT(replaced.error().message, HasSubstr("a recording goes on, and cannot hold the crowd of a file"));
  EXPECT_EQ(show->stage().crowd().size(), 12U);
  ASSERT_TRUE(show->stop_recording());
  ASSERT_TRUE(show->replace_trajectories(people(7)));
  EXPECT_THAT(show->start_recording(folder_ / "run.rec").error().message,
              HasSubstr("the scene tracks is not recorded"));
}

}  // namespace
}  // namespace throng::app::recorded_crowd_test
