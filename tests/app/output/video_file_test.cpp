// Videos by a script in the place of ffmpeg, which need not be installed.
#include "app/output/video_file.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/files/exit_status.h"
#include "app/files/program_words.h"
#include "tests/app/output/fake_ffmpeg.h"
#include "tests/app/temporary_folder.h"

namespace throng::app::video_file_test {
namespace {

namespace fs = std::filesystem;
using test::contents_of;
using test::FakeFfmpeg;
using testing::HasSubstr;

class Video : public test::TemporaryFolder {
 protected:
  Video() { end_in_words(); }

  /// Adds frames until one is refused, and returns why; the video's end says it where none is.
  Status make(int frames, int width, int height, double rate = 30) const {
    auto video = VideoFile::create(file_, {width, height, rate});
    if (!video) return video.error();
    for (int frame = 0; frame < frames; ++frame) {
      if (Status added = (*video)->add(render::Image::blank(width, height)); !added) return added;
    }
    return (*video)->finish();
  }

  std::size_t parts() const {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder_)) count += entry.path().extension() == ".part" ? 1U : 0U;
    return count;
  }

  const fs::path file_ = folder_ / "crowd.mp4";
};

TEST_F(Video, GetsEveryFrameInSizeAndRate) {
  const FakeFfmpeg ffmpeg(folder_, FakeFfmpeg::takes_all);
  ASSERT_TRUE(make(7, 20, 10, 59.94));
  EXPECT_EQ(FakeFfmpeg::frames_in(file_).size(), 7U * 20 * 10 * 3);
  EXPECT_THAT(ffmpeg.words(), HasSubstr("-pixel_format rgb24 -video_size 20x10 -framerate 59.94"));
  EXPECT_THAT(ffmpeg.words(), HasSubstr("-c:v libx264"));
  EXPECT_THAT(ffmpeg.words(), HasSubstr("format=yuv420p"));
  EXPECT_EQ(parts(), 0U);
}

TEST_F(Video, OfTheWebIsVp9) {
  const FakeFfmpeg ffmpeg(folder_, R"(printf '\032\105\337\243\200\030\123\200\147\200' > "$file")");
  auto video = VideoFile::create(folder_ / "crowd.webm", {2, 2, 60});
  ASSERT_TRUE(video);
  ASSERT_TRUE((*video)->finish());
  EXPECT_THAT(ffmpeg.words(), HasSubstr("-c:v libvpx-vp9"));
  EXPECT_THAT(ffmpeg.words(), HasSubstr("-f webm"));
}

TEST_F(Video, IsRefusedWithThePackageWhereThereIsNoFfmpeg) {
  const FakeFfmpeg ffmpeg(folder_, "");
  fs::remove(fs::path(ffmpeg.path()) / "ffmpeg");
  const Status checked = check_encoder(file_);
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().message,
            "--video: ffmpeg does not start: there is none in PATH; install the package ffmpeg, or write --pictures");
}

TEST_F(Video, IsRefusedWithTheStatusOfAnFfmpegThatSaysNothing) {
  const FakeFfmpeg ffmpeg(folder_, "");
  std::ofstream(fs::path(ffmpeg.path()) / "ffmpeg") << "#!/bin/sh\nexit 9\n";
  const Status checked = check_encoder(file_);
  ASSERT_FALSE(checked);
  EXPECT_THAT(checked.error().message, HasSubstr("ffmpeg does not start: it ends with status 9; install"));
}

TEST_F(Video, IsRefusedWithTheNameOfTheEncoderThatIsNotThere) {
  const FakeFfmpeg ffmpeg(folder_, "", " libx264 libx264rgb ");
  EXPECT_TRUE(check_encoder(file_));
  const Status checked = check_encoder("crowd.webm");
  ASSERT_FALSE(checked);
  EXPECT_THAT(checked.error().message, HasSubstr("crowd.webm: this ffmpeg has no encoder libvpx-vp9; install"));
}

TEST_F(Video, ThatFfmpegGivesUpSaysItsLastWordsAndLeavesTheOldFile) {
  const FakeFfmpeg ffmpeg(folder_, "head -c 1000 > /dev/null; echo first >&2; echo 'the disk has no room' >&2; exit 3");
  std::ofstream(file_) << "old";
  const Status made = make(1000, 200, 100);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message,
            file_.string() +
                ": ffmpeg ended before the video did (status 3): the disk has no room; write --pictures instead");
  EXPECT_EQ(contents_of(file_), "old");
  EXPECT_EQ(parts(), 0U);
}

TEST_F(Video, ThatFailsAtItsEndIsNoVideo) {
  const FakeFfmpeg ffmpeg(folder_,
                          std::string(FakeFfmpeg::takes_all) + "; echo 'cannot write the trailer' >&2; exit 1");
  const Status made = make(3, 20, 10);
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message, HasSubstr("failed at the end of the video (status 1): cannot write the trailer"));
  EXPECT_FALSE(fs::exists(file_));
  EXPECT_EQ(parts(), 0U);
}

TEST_F(Video, ThatIsCutShortIsNoVideoWhateverTheStatusOfFfmpeg) {
  const FakeFfmpeg ffmpeg(folder_, std::string(FakeFfmpeg::takes_all) + "; truncate -s -1 \"$file\"");
  const Status made = make(3, 20, 10);
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message, HasSubstr("ffmpeg left a video that is not whole (status 0); write --pictures"));
  EXPECT_FALSE(fs::exists(file_));
  EXPECT_EQ(parts(), 0U);
}

TEST_F(Video, OnAFullDiskSaysSoWhateverTheStatusOfFfmpeg) {
  const FakeFfmpeg ffmpeg(folder_, "cat > \"$file\"; echo 'Error closing file: No space left on device' >&2");
  std::ofstream(file_) << "old";
  const Status made = make(3, 20, 10);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message, file_.string() +
                                      ": cannot be written: the disk is full; make room, or name a file on another "
                                      "disk");
  EXPECT_EQ(contents_of(file_), "old");
}

TEST_F(Video, IsNotHeldUpByAnFfmpegThatTalks) {
  const FakeFfmpeg ffmpeg(folder_, "head -c 300000 /dev/zero | tr '\\0' x; " + std::string(FakeFfmpeg::takes_all));
  ASSERT_TRUE(make(20, 100, 100));
  EXPECT_EQ(FakeFfmpeg::frames_in(file_).size(), 20U * 100 * 100 * 3);
}

TEST_F(Video, ThatIsGivenUpEndsItsFfmpegAndLeavesNothing) {
  const FakeFfmpeg ffmpeg(folder_, FakeFfmpeg::takes_all);
  {
    auto video = VideoFile::create(file_, {20, 10, 30});
    ASSERT_TRUE(video);
    ASSERT_TRUE((*video)->add(render::Image::blank(20, 10)));
  }
  EXPECT_FALSE(fs::exists(file_));
  EXPECT_EQ(parts(), 0U);
}

TEST(LastLine, IsTheLastThatSaysSomething) {
  EXPECT_EQ(last_line("one\ntwo\n\n  \n"), "two");
  EXPECT_EQ(last_line("frame 1\rframe 2\r"), "frame 2");
  EXPECT_EQ(last_line("alone"), "alone");
  EXPECT_EQ(last_line("\n\n"), "");
}

}  // namespace
}  // namespace throng::app::video_file_test
