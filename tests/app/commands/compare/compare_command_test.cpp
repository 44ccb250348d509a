#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/output/regression/compare.h"
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

TEST_F(Compare, PicturesAreTheSameWithMoreBits) {
  render::NumberImage deep = render::in_16_bits(render::Image::blank(64, 32));
  ASSERT_TRUE(render::write_png(deep, folder_ / "deep.png"));
  EXPECT_EQ(compare("deep.png").output, "no pixel differs\n");
  --deep.numbers[0];
  ASSERT_TRUE(render::write_png(deep, folder_ / "deep.png"));
  const ProgramRun run = compare("deep.png");
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_EQ(run.output,
            "mean below 0.001, worst block below 0.001 at 0,0, 0.00% of pixels differ by more than 16 steps\n");
}

TEST_F(Compare, AnotherAlphaIsAnotherPicture) {
  render::Image clear = render::Image::blank(64, 32);
  for (int x = 0; x < 64; ++x) clear.pixel(x, 3)[3] = 0;
  ASSERT_TRUE(render::write_png(clear, folder_ / "clear.png"));
  const ProgramRun run = compare("clear.png");
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_THAT(run.output, HasSubstr("3.12% of pixels differ"));
}

TEST_F(Compare, ADamagedPictureIsNamed) {
  std::filesystem::resize_file(folder_ / "b.png", 60);
  const ProgramRun run = compare("b.png");
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_THAT(run.errors, HasSubstr("b.png: "));
  EXPECT_EQ(run.errors.find('\n'), run.errors.size() - 1) << run.errors;
}

/// Compares pictures of numbers, 16 by 16, of which one pixel differs.
class CompareNumbers : public test::TemporaryFolder {
 protected:
  void write(const char* name, std::uint16_t number, const std::vector<render::PngText>& texts) const {
    render::NumberImage image{16, 16, std::vector<std::uint16_t>(256, 1000)};
    image.numbers[7] = number;
    EXPECT_TRUE(render::write_png(image, folder_ / name, texts));
  }
  ProgramRun compare(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"compare", folder_ / "a.png", folder_ / "b.png"});
    return run_program(more);
  }
};

TEST_F(CompareNumbers, ALabelIsTheSameOrNot) {
  for (const auto& texts : {label_texts(), std::vector<render::PngText>()}) {
    write("a.png", 1, texts);
    write("b.png", 2, texts);
    const ProgramRun run = compare();
    EXPECT_EQ(run.exit_status, 1);
    const std::string what = texts.empty() ? "numbers" : "labels";
    EXPECT_EQ(run.output, "worst block 0.39% at 0,0, 0.39% of pixels have other " + what + "\n");
    write("b.png", 1, texts);
    EXPECT_EQ(compare().output, "no pixel differs\n");
  }
}

TEST_F(CompareNumbers, StepsOfColoursAreNoLimitOfLabels) {
  write("a.png", 1, label_texts());
  write("b.png", 2, label_texts());
  const ProgramRun run = compare({"--mean", "0.8"});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_EQ(run.errors,
            "throng: limits of mean and worst block are steps of colours, and the pictures hold labels; limit the "
            "share alone\n");
  EXPECT_EQ(compare({"--share", "0.01"}).exit_status, 0);
}

TEST_F(CompareNumbers, DepthsAreApartInMetresWhateverTheirSteps) {
  write("a.png", 1512, depth_texts(0.001));
  write("b.png", 1000, depth_texts(0.001));
  const ProgramRun run = compare();
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_EQ(run.output, "mean 0.002 m, worst block 0.002 m at 0,0, 0.39% of pixels have other depths\n");
  write("a.png", 1000, depth_texts(0.002));
  EXPECT_THAT(compare().output, HasSubstr("mean 1.000 m"));
}

TEST_F(CompareNumbers, NothingIsAnotherDepthThanTheFarthest) {
  write("a.png", 0, depth_texts(0.001));
  write("b.png", 65535, depth_texts(0.001));
  EXPECT_EQ(compare().exit_status, 1);
}

TEST_F(CompareNumbers, WhatHoldsOtherThingsIsRefused) {
  write("a.png", 1, label_texts());
  ASSERT_TRUE(render::write_png(render::Image::blank(16, 16), folder_ / "b.png"));
  const ProgramRun run = compare();
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_EQ(run.errors,
            "throng: what the pictures hold differs: labels expected, colours drawn; compare two of one kind\n");
}

TEST_F(CompareNumbers, WhatDiffersIsWhite) {
  write("a.png", 1, label_texts());
  write("b.png", 2, label_texts());
  EXPECT_EQ(compare({"--difference", folder_ / "d.png"}).exit_status, 1);
  const auto difference = render::read_png(folder_ / "d.png");
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->pixel(7, 0)[0], 255);
  EXPECT_EQ(difference->pixel(8, 0)[0], 0);
}

}  // namespace
}  // namespace throng::app::compare_command_test
