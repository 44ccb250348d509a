#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/render/image.h"
#include "tests/app/program_run.h"
#include "tests/app/temporary_folder.h"

namespace throng::app::compare_command_test {
namespace {

using testing::HasSubstr;

class Compare : public test::TemporaryFolder {
 protected:
  Compare() {
    render::Image picture = render::Image::blank(64, 32);
    EXPECT_TRUE(render::write_png(picture, folder_ / "a.png"));
    for (int x = 16; x < 32; ++x) picture.pixel(x, 5)[1] = 0;
    EXPECT_TRUE(render::write_png(picture, folder_ / "b.png"));
    EXPECT_TRUE(render::write_png(render::Image::blank(64, 31), folder_ / "c.png"));
  }
  ProgramRun compare(const char* actual, std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"compare", folder_ / "a.png", folder_ / actual});
    return run_program(more);
  }
};

TEST_F(Compare, PicturesThatAreTheSame) {
  const ProgramRun run = compare("a.png");
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  EXPECT_EQ(run.output, "no pixel differs\n");
}

TEST_F(Compare, PicturesThatDifferGivesTheNumbersAndOne) {
  const ProgramRun run = compare("b.png");
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_EQ(run.output, "mean 0.664, worst block 5.312 at 16,0, 0.78% of pixels differ by more than 16 steps\n");
  EXPECT_THAT(run.errors,
              HasSubstr("throng: mean 0.664, at most 0 (no tolerance is given); worst block 5.312 at 16,0"));
}

TEST_F(Compare, HoldsThemToTheLimitsThatAreGiven) {
  EXPECT_EQ(compare("b.png", {"--mean", "0.7"}).exit_status, 0);
  EXPECT_EQ(compare("b.png", {"--mean", "0.7", "--worst-block", "5"}).exit_status, 1);
  EXPECT_EQ(compare("b.png", {"--share", "0.01"}).exit_status, 0);
  EXPECT_EQ(compare("b.png", {"--share", "2"}).exit_status, 2);
}

TEST_F(Compare, WritesTheDifference) {
  EXPECT_EQ(compare("b.png", {"--difference", folder_ / "d.png"}).exit_status, 1);
  const auto difference = render::read_png(folder_ / "d.png");
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->pixel(20, 5)[1], 255);
  EXPECT_EQ(difference->pixel(20, 6)[1], 0);
}

TEST_F(Compare, SizesThatDifferAreBothSaid) {
  const ProgramRun run = compare("c.png");
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_EQ(run.errors, "throng: the sizes differ: 64x32 expected, 64x31 drawn\n");
}

TEST_F(Compare, ADamagedPictureIsNamed) {
  std::filesystem::resize_file(folder_ / "b.png", 60);
  const ProgramRun run = compare("b.png");
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_THAT(run.errors, HasSubstr("b.png: "));
  EXPECT_EQ(run.errors.find('\n'), run.errors.size() - 1) << run.errors;
}

}  // namespace
}  // namespace throng::app::compare_command_test
