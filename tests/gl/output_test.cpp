// Video, pictures and labels of every frame: what is there after a run, and what a run goes on with.
#include "app/output/output.h"

#include <algorithm>
#include <csignal>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "throng/render/image.h"

#include "app/files/exit_status.h"
#include "app/window/demo.h"
#include "tests/app/output/fake_ffmpeg.h"
#include "tests/app/program_run.h"
#include "tests/app/temporary_folder.h"
#include "tests/gl/small_picture.h"

namespace throng::app::output_test {
namespace {

namespace fs = std::filesystem;
using test::contents_of;
using test::FakeFfmpeg;
using testing::HasSubstr;

constexpr int width = 96, height = 64;
constexpr std::size_t frame_bytes = std::size_t{3} * width * height;

class OutputOfARun : public test::TemporaryFolder {
 protected:
  OutputOfARun() : options_(picture_by_processor(width, height)) {
    end_in_words();  // a pipe without a reader is an error of its writer, as in the program
    options_.tuning.agents = 12;
    options_.tuning.shadows = options_.tuning.crowd_shade = options_.tuning.scenery = false;
    options_.tuning.lod.rule = LodRule::off;
    options_.msaa = 0;
    options_.output.run = {"--agents", "12"};
  }

  /// Runs so many frames, and returns what was said on standard error.
  std::string run(int frames, int expected_status = 0) {
    options_.frames = frames;
    testing::internal::CaptureStderr();
    EXPECT_EQ(run_demo(options_), expected_status);
    return testing::internal::GetCapturedStderr();
  }

  static std::map<std::string, std::string> files_in(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(folder)) {
      files[entry.path().filename()] = contents_of(entry.path());
    }
    return files;
  }

  DemoOptions options_;
};

TEST_F(OutputOfARun, ThatGoesOnIsThatOfOneRun) {
  options_.output.pictures = folder_ / "whole";
  options_.output.labels = folder_ / "whole labels";
  run(5);
  options_.output.pictures = folder_ / "parts";
  options_.output.labels = folder_ / "parts of labels";
  run(2);
  EXPECT_THAT(run(5), HasSubstr("2 frames were there from before"));
  EXPECT_EQ(files_in(folder_ / "whole").size(), 5U + 1);
  EXPECT_EQ(files_in(folder_ / "whole"), files_in(folder_ / "parts"));
  EXPECT_EQ(files_in(folder_ / "whole labels").size(), 2U * 5 + 3);
  EXPECT_EQ(files_in(folder_ / "whole labels"), files_in(folder_ / "parts of labels"));
}

TEST_F(OutputOfARun, KeepsWholePicturesAndDrawsDamagedOnesAgain) {
  options_.output.pictures = folder_ / "pictures";
  run(3);
  const auto before = files_in(folder_ / "pictures");
  ASSERT_TRUE(render::write_png(render::Image::blank(width, height), folder_ / "pictures/frame_000001.png"));
  const std::string blank = contents_of(folder_ / "pictures/frame_000001.png");
  fs::resize_file(folder_ / "pictures/frame_000002.png", 100);
  ASSERT_TRUE(render::write_png(render::Image::blank(10, 10), folder_ / "pictures/frame_000003.png"));
  run(3);
  const auto after = files_in(folder_ / "pictures");
  EXPECT_EQ(after.at("frame_000001.png"), blank);
  EXPECT_EQ(after.at("frame_000002.png"), before.at("frame_000002.png"));
  EXPECT_EQ(after.at("frame_000003.png"), before.at("frame_000003.png"));
}

TEST_F(OutputOfARun, OfAnotherRunIsRefused) {
  options_.output.pictures = folder_ / "pictures";
  run(1);
  options_.output.run = {"--agents", "13"};
  EXPECT_THAT(run(1, 1), HasSubstr("is of another run, `throng --agents 12`"));
}

TEST_F(OutputOfARun, ShowsItsLastFrameInAScreenshotThoughItWasThere) {
  options_.output.pictures = folder_ / "pictures";
  run(2);
  options_.screenshot = folder_ / "last.png";
  run(2);
  const auto last = render::read_png(folder_ / "last.png");
  const auto picture = render::read_png(folder_ / "pictures/frame_000002.png");
  ASSERT_TRUE(last && picture);
  EXPECT_TRUE(last->rgba == picture->rgba);
}

TEST_F(OutputOfARun, HasIdsAboveHeadsInEachPictureAndInNoLabels) {
  options_.width = 400, options_.height = 240;
  const auto run_into = [this](const char* pictures, const char* labels) {
    options_.output.pictures = folder_ / pictures;
    options_.output.labels = folder_ / labels;
    run(2);
  };
  run_into("plain", "labels");
  options_.tuning.ids = true;
  run_into("with ids", "labels beside them");
  EXPECT_EQ(files_in(folder_ / "labels"), files_in(folder_ / "labels beside them"));
  for (const char* const name : {"frame_000001.png", "frame_000002.png"}) {
    const auto plain = render::read_png(folder_ / "plain" / name);
    const auto ids = render::read_png(folder_ / "with ids" / name);
    ASSERT_TRUE(plain && ids);
    std::size_t others = 0;
    for (std::size_t at = 0; at < plain->rgba.size(); ++at) others += plain->rgba[at] != ids->rgba[at] ? 1U : 0U;
    EXPECT_GT(others, 0U) << name;
    EXPECT_LT(others, plain->rgba.size() / 4) << name << ": the panel is not there";
  }
}

TEST_F(OutputOfARun, HasTheLegendInEachPictureAndInNoLabels) {
  options_.width = 400, options_.height = 240;
  options_.tuning.debug_view = DebugView::density;
  const auto run_into = [this](const char* pictures, const char* labels) {
    options_.output.pictures = folder_ / pictures;
    options_.output.labels = folder_ / labels;
    options_.screenshot = folder_ / (std::string(pictures) + ".png");
    run(3);
  };
  run_into("plain", "labels");
  options_.legend = true;
  run_into("with legend", "labels beside it");
  EXPECT_EQ(files_in(folder_ / "labels"), files_in(folder_ / "labels beside it"));
  render::Image before;
  for (const char* const name : {"frame_000001.png", "frame_000002.png", "frame_000003.png"}) {
    const auto plain = render::read_png(folder_ / "plain" / name);
    const auto legend = render::read_png(folder_ / "with legend" / name);
    ASSERT_TRUE(plain && legend);
    for (std::size_t pixel = 0; pixel < plain->rgba.size() / 4; ++pixel) {
      const std::size_t x = pixel % 400, y = pixel / 400;
      const bool is_card = x < 250 && y > 100;
      const bool is_same = std::equal(&plain->rgba[4 * pixel], &plain->rgba[4 * pixel + 3], &legend->rgba[4 * pixel]);
      ASSERT_TRUE(is_same || is_card) << x << " " << y;
    }
    EXPECT_FALSE(plain->rgba == legend->rgba) << name;
    EXPECT_FALSE(before.rgba == legend->rgba) << "its time goes on";
    before = *legend;
  }
  const auto last = render::read_png(folder_ / "with legend.png");
  ASSERT_TRUE(last);
  EXPECT_TRUE(last->rgba == before.rgba) << "the legend is drawn once";
}

TEST_F(OutputOfARun, HasThePanelInEachPicture) {
  options_.width = 400, options_.height = 240;
  options_.output.pictures = folder_ / "plain";
  run(2);
  options_.output.pictures = folder_ / "with panel";
  options_.ui = options_.ui_fixed = true;
  run(2);
  for (const char* const name : {"frame_000001.png", "frame_000002.png"}) {
    const auto plain = render::read_png(folder_ / "plain" / name);
    const auto panel = render::read_png(folder_ / "with panel" / name);
    ASSERT_TRUE(plain && panel);
    const std::size_t right = 4 * (120 * 400 + 390);
    EXPECT_FALSE(std::equal(&plain->rgba[right], &plain->rgba[right + 3], &panel->rgba[right])) << name;
  }
}

TEST_F(OutputOfARun, HasInItsVideoWhatItsPicturesHaveAlsoThoseThatWereThere) {
  const FakeFfmpeg ffmpeg(folder_, FakeFfmpeg::takes_all);
  options_.output.pictures = folder_ / "pictures";
  run(2);
  options_.output.video = folder_ / "crowd.mp4";
  options_.dt = 0.04;
  EXPECT_THAT(run(4), HasSubstr("0.2 s of video"));
  EXPECT_THAT(ffmpeg.words(), HasSubstr("-framerate 25 "));
  const std::string video = FakeFfmpeg::frames_in(options_.output.video);
  ASSERT_EQ(video.size(), 4 * frame_bytes);
  for (int frame = 1; frame <= 4; ++frame) {
    const auto picture = render::read_png(folder_ / ("pictures/frame_00000" + std::to_string(frame) + ".png"));
    ASSERT_TRUE(picture);
    std::string rgb;
    for (std::size_t i = 0; i < picture->rgba.size(); ++i) {
      if (i % 4 != 3) rgb += static_cast<char>(picture->rgba[i]);
    }
    EXPECT_TRUE(rgb == video.substr(static_cast<std::size_t>(frame - 1) * frame_bytes, frame_bytes)) << frame;
  }
}

TEST_F(OutputOfARun, IsRefusedBeforeAnythingIsLoadedWithoutFfmpeg) {
  const FakeFfmpeg ffmpeg(folder_, "");
  fs::remove(fs::path(ffmpeg.path()) / "ffmpeg");
  options_.output.video = folder_ / "crowd.mp4";
  options_.models = {"no-such-model.glb"};
  EXPECT_THAT(run(1, 1), HasSubstr("install the package ffmpeg"));
}

TEST_F(OutputOfARun, EndsInWordsWhenFfmpegDoes) {
  const FakeFfmpeg ffmpeg(folder_, "head -c 30000 > /dev/null; echo 'no space left' >&2; exit 1");
  options_.output.video = folder_ / "crowd.mp4";
  const std::string said = run(200, 1);
  EXPECT_THAT(
      said,
      HasSubstr("crowd.mp4: ffmpeg ended before the video did (status 1): no space left; write --pictures instead\n"));
  EXPECT_EQ(std::ranges::count(said, '\n'), 1);
  EXPECT_FALSE(fs::exists(options_.output.video));
}

TEST_F(OutputOfARun, ThatASignalEndsHasAVideoOfWhatThereIs) {
  const FakeFfmpeg ffmpeg(folder_, FakeFfmpeg::takes_all);
  const std::string video = folder_ / "crowd.mp4";
  const auto ended = run_program({"--headless", "--agents", "5", "--size", "64x48", "--msaa", "0", "--shadows", "off",
                                  "--frames", "1000000", "--video", video},
                                 {.meanwhile = send(SIGINT, video + ".PID.part"), .seconds = 60});
  EXPECT_EQ(ended.exit_status, 130) << ended.errors;
  EXPECT_THAT(ended.errors, HasSubstr(" of video, "));
  ASSERT_TRUE(fs::exists(video));
  const std::string frames = FakeFfmpeg::frames_in(video);
  EXPECT_GT(frames.size(), 0U);
  EXPECT_EQ(frames.size() % (std::size_t{3} * 64 * 48), 0U);
  EXPECT_EQ(std::ranges::count_if(fs::directory_iterator(folder_),
                                  [](const auto& entry) { return entry.path().extension() == ".part"; }),
            0);
}

}  // namespace
}  // namespace throng::app::output_test
