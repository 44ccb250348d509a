// A picture without the panel and a video, as files, from a window that goes on.
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "throng/render/image.h"

#include "tests/app/output/fake_ffmpeg.h"
#include "tests/window/window_driver.h"

namespace throng::app::video_test {
namespace {

using Json = nlohmann::json;
using test::FakeFfmpeg;

constexpr int width = 640, height = 360;
constexpr std::size_t frame_bytes = std::size_t{3} * width * height;

/// A recorded crowd of a second with two people, and an ffmpeg that keeps the frames that it gets.
class FilesOfAWindow : public WindowDriver {
 protected:
  void SetUp() override {
    const char* const path = std::getenv("PATH");
    others_ = path == nullptr ? "" : path;
    ffmpeg_ = std::make_unique<FakeFfmpeg>(folder(), FakeFfmpeg::takes_all);
    setenv("PATH", (ffmpeg_->path() + ":" + others_).c_str(), 1);
    WindowDriver::SetUp();
  }
  std::vector<std::string> options() const override {
    const std::string file = (folder() / "walk.csv").string();
    std::ofstream rows(file);
    rows << "id,time,x,y\n";
    for (int row = 0; row <= seconds() * 10; ++row) {
      rows << "7," << 0.1 * row << ',' << 0.1 * row << ",0\n8," << 0.1 * row << ',' << 0.1 * row << ",1.5\n";
    }
    return {"--trajectories", file,
            "--camera",       "0,1.6,6,0,-8,60",
            "--size",         std::to_string(width) + "x" + std::to_string(height),
            "--msaa",         "0",
            "--shadows",      "off",
            "--crowd-shade",  "off",
            "--set",          "paused=on"};
  }
  /// Returns the length of the recorded crowd.
  virtual int seconds() const { return 1; }
  std::size_t frames_in(const std::string& video) const {
    return FakeFfmpeg::frames_in(folder() / video).size() / frame_bytes;
  }
  Json wait_for_job(const std::string& what, const std::function<bool(const Json&)>& holds) {
    return wait_for(what, [&](const Json& map) { return holds(map["report"]["jobs"]); });
  }

  std::unique_ptr<FakeFfmpeg> ffmpeg_;
  std::string others_;  // what PATH was
};

class LongVideo : public FilesOfAWindow {
 protected:
  int seconds() const override { return 100; }
};

TEST_F(FilesOfAWindow, HaveAVideoOfThePartOfARecordedCrowdWhileTheWindowGoesOn) {
  press("v");
  wait_for_job("its card", [](const Json& jobs) { return jobs.size() == 1; });
  EXPECT_FALSE(std::filesystem::exists(folder() / "throng-1.mp4"));
  press("space");
  wait_for("the clock to go on", [](const Json& map) { return map["report"]["tracks"]["seconds"] > 0.3; });
  wait_for_message("Wrote ");
  EXPECT_EQ(frames_in("throng-1.mp4"), 30) << "of a second";
  EXPECT_TRUE(next_map()["report"]["jobs"].empty());
}

TEST_F(LongVideo, KeepsItsFramesSoFarWhenItIsCancelled) {
  press("v");
  wait_for_job("a frame", [](const Json& jobs) { return !jobs.empty() && jobs[0]["share"] > 0.0; });
  wait_for("the button", [](const Json& map) { return map["widgets"].contains("cancel:video"); });
  click("cancel:video");
  wait_for_message("Wrote ");
  EXPECT_GT(frames_in("throng-1.mp4"), 0);
  EXPECT_LT(frames_in("throng-1.mp4"), 3000);
}

TEST_F(LongVideo, KeepsItsFramesSoFarWhenTheWindowIsClosed) {
  press("v");
  wait_for_job("a frame", [](const Json& jobs) { return !jobs.empty() && jobs[0]["share"] > 0.0; });
  kill(program().process(), SIGTERM);
  EXPECT_EQ(program().exit_status(soon()), 128 + SIGTERM);
  EXPECT_GT(frames_in("throng-1.mp4"), 0);
}

TEST_F(FilesOfAWindow, SayWhyThereIsNoVideo) {
  std::filesystem::remove(std::filesystem::path(ffmpeg_->path()) / "ffmpeg");
  setenv("PATH", ffmpeg_->path().c_str(), 1);
  start_program(options());
  setenv("PATH", others_.c_str(), 1);
  press("v");
  wait_for_message("No video: --video: ffmpeg does not start: ");
}

TEST_F(FilesOfAWindow, HaveAPictureAtTwiceTheSizeWithoutThePanel) {
  bring_into_sight("Picture times");
  type_into("Picture times.field", "2");
  press("shift+F12");
  wait_for_message("Wrote ");
  const auto image = render::read_png(folder() / "throng-1.png");
  ASSERT_TRUE(image);
  EXPECT_EQ(image->width, 2 * width);
  EXPECT_EQ(image->height, 2 * height);
  press("F12");
  wait_for_message("throng-2.png");
  const auto with_panel = render::read_png(folder() / "throng-2.png");
  ASSERT_TRUE(with_panel);
  EXPECT_EQ(with_panel->width, width);
}

}  // namespace
}  // namespace throng::app::video_test
