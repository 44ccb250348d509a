// A video of a window is made by a run without one, whose options say all that is open.
#include "app/window/video_job.h"

#include <algorithm>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/commands/command_line/options.h"

namespace throng::app::video_job_test {
namespace {

using testing::Contains;
using testing::Not;

WantedVideo wanted() {
  return {.file = "throng-1.mp4",
          .size = {1281, 721},
          .setup = {.characters = {{.file = ""}}, .preset = {.tuning = {}, .camera = CameraPose{.x = 3}}},
          .seconds = 2.0,
          .crowd_seconds = 12.5};
}

WantedVideo recorded() {
  WantedVideo video = wanted();
  video.setup.preset.tuning.scene = Scene::tracks;
  video.setup.trajectories = {.file = "walk.csv", .start = 7.0, .rate = -2.0, .part = {{5.0, 9.0}}, .repeats = true};
  return video;
}

/// Returns the options with which the run begins.
DemoOptions options_of_run(const WantedVideo& video, const DemoOptions& of_window = {}) {
  std::vector<std::string> words = words_of_video(video, of_window);
  const ParsedCommand command = parse_command_line(words);
  if (const auto* const error = std::get_if<UsageError>(&command)) ADD_FAILURE() << error->message;
  const auto* const options = std::get_if<DemoOptions>(&command);
  return options == nullptr ? DemoOptions() : *options;
}

TEST(RunForAVideo, IsOfTheCrowdThatIsOpenFromNowOn) {
  const DemoOptions options = options_of_run(wanted());
  EXPECT_NE(options.context, ContextKind::window);
  EXPECT_EQ(options.output.video, "throng-1.mp4");
  EXPECT_EQ(options.unseen_seconds, 12.5);
  EXPECT_EQ(options.frames, 60) << "30 a second";
  EXPECT_EQ(options.output.frames_per_second, 30.0);
  EXPECT_NEAR(options.dt.value(), 1.0 / 30, 1e-9);
  EXPECT_EQ(options.camera->x, 3);
  EXPECT_TRUE(options.says_progress);
}

TEST(RunForAVideo, HasThePixelsOfTheWindowInEvenNumbers) {
  const DemoOptions options = options_of_run(wanted());
  EXPECT_EQ(options.width, 1280);
  EXPECT_EQ(options.height, 720);
}

TEST(RunForAVideo, PlaysThePartOfARecordedCrowdOnceFromItsBeginning) {
  const DemoOptions options = options_of_run(recorded());
  EXPECT_EQ(options.trajectories.part, std::pair(5.0, 9.0));
  EXPECT_EQ(options.trajectories.rate, -2.0);
  EXPECT_FALSE(options.trajectories.start);
  EXPECT_EQ(options.trajectories.repeats, false);
  EXPECT_FALSE(options.frames_given) << "it goes to the end of the part";
  EXPECT_FALSE(options.unseen_seconds);
}

TEST(RunForAVideo, LeavesOutARecordedCrowdThatIsNotShown) {
  WantedVideo video = recorded();
  video.setup.preset.tuning.scene = Scene::plaza;
  EXPECT_EQ(options_of_run(video).trajectories.file, "");
}

TEST(RunForAVideo, GoesAtTheSpeedOfTheWindowsClockAlsoFromAPause) {
  WantedVideo video = wanted();
  video.setup.preset.tuning.time_scale = 0.5F;
  video.setup.preset.tuning.paused = true;
  const DemoOptions options = options_of_run(video);
  EXPECT_NEAR(options.dt.value(), 0.5 / 30, 1e-9);
  EXPECT_EQ(options.output.frames_per_second, 30.0);
  EXPECT_FALSE(options.tuning.paused);
}

TEST(RunForAVideo, ExplainsTheColoursThatTheWindowShows) {
  WantedVideo video = wanted();
  EXPECT_THAT(words_of_video(video, {}), Not(Contains("--legend")));
  video.setup.preset.tuning.debug_view = DebugView::speed;
  EXPECT_TRUE(options_of_run(video).legend);
}

TEST(ProgressOfAVideo, IsTheNewestLineOfItsRun) {
  const VideoProgress progress =
      progress_in("a notice about a frame\nframe 1 of 60, 0 a second\nframe 30 of 60, 2 a second\n");
  EXPECT_EQ(progress.words, "frame 30 of 60, 2 a second");
  EXPECT_EQ(progress.share, 0.5);
  EXPECT_EQ(progress_in("frame 7, 14 a second\n").share, -1.0) << "its length is not known";
}

TEST(ProgressOfAVideo, IsNoneBeforeTheFirstFrame) {
  EXPECT_EQ(progress_in("").words, "");
  EXPECT_EQ(progress_in("throng: walk.csv: 3 people\n").words, "");
}

}  // namespace
}  // namespace throng::app::video_job_test
