// Compares a split view with its two pictures, each drawn alone.
#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "throng/render/image.h"

#include "app/show/opened_show.h"
#include "app/show/painter.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "tests/gl/picture_tolerance.h"
#include "tests/gl/small_picture.h"

namespace throng::app::split_view_test {
namespace {

using render::Image;
using render::test::looks_the_same;
using render::test::measure_difference;

constexpr int width = 320, height = 180, line = 128;
constexpr int beside_the_line = 2;  // pixels

DemoOptions skipping_crowd() {
  DemoOptions options = picture_by_processor(width, height);
  options.tuning.agents = 40;
  options.tuning.placed_feet = false;  // without level of detail every agent would have them
  options.tuning.inspection = {.split_at = static_cast<float>(line) / width, .forced_interval = 16};
  options.tuning.lod.level_distances[0] = options.tuning.lod.level_distances[1] = 1.0F;
  options.tuning.lod.level_distances[2] = 2.0F;
  return options;
}

Image part(const Image& image, int from, int to) {
  Image columns = Image::blank(to - from, image.height);
  for (int y = 0; y < image.height; ++y)
    std::copy(image.pixel(from, y), image.pixel(to - 1, y) + 4, columns.pixel(0, y));
  return columns;
}
Image left(const Image& image) { return part(image, 0, line - beside_the_line); }
Image right(const Image& image) { return part(image, line + beside_the_line, width); }

/// Shows a crowd in the middle of its intervals.
class SplitView : public testing::Test {
 protected:
  void SetUp() override { begin(skipping_crowd()); }

  void begin(const DemoOptions& options) {
    show_.reset();
    StartError error;
    show_ = open_show(options, error);
    ASSERT_NE(show_, nullptr) << error.message;
    for (int frame = 0; frame < 27; ++frame) show_->animate(to_ticks(1.0 / 60.0));
  }
  Image picture(Split split) {
    Tuning tuning = show_->stage().tuning();
    tuning.inspection.split = split;
    EXPECT_TRUE(show_->take(Apply{tuning}));
    EXPECT_TRUE(show_->draw());
    return show_->painter().renderer().read_image();
  }
  /// Draws the same moment as `--lod off` does.
  Image exact_picture() {
    DemoOptions options = skipping_crowd();
    options.tuning = without_level_of_detail(options.tuning);
    begin(options);
    return picture(Split::off);
  }

  Show& show() { return *show_; }

 private:
  std::unique_ptr<Show> show_;
};

TEST_F(SplitView, ShowsTheExactCrowdOnTheLeftAndTheUsualOneOnTheRight) {
  const Image usual = picture(Split::off), split = picture(Split::shown), exact = exact_picture();
  EXPECT_FALSE(looks_the_same(*measure_difference(left(exact), left(usual)))) << "nothing would be shown";
  EXPECT_TRUE(looks_the_same(*measure_difference(left(exact), left(split))));
  EXPECT_EQ(measure_difference(right(usual), right(split))->mean, 0.0);
}

TEST_F(SplitView, ShowsTheDifferenceEightTimesAsBright) {
  const Image usual = picture(Split::off), split = picture(Split::difference), exact = exact_picture();
  EXPECT_TRUE(looks_the_same(*measure_difference(left(exact), left(split))));
  const Image expected = app::paint_difference(exact, usual);
  EXPECT_FALSE(looks_the_same(*measure_difference(Image::blank(right(usual).width, height), right(expected))));
  EXPECT_TRUE(looks_the_same(*measure_difference(right(expected), right(split))));
}

TEST_F(SplitView, LeavesTheUsualPictureAsItWas) {
  const Image before = picture(Split::off);
  picture(Split::shown);
  EXPECT_EQ(measure_difference(before, picture(Split::off))->mean, 0.0);
  const auto slots = show().stage().posed().shown().pose(0).to.first_line;
  picture(Split::difference);
  EXPECT_EQ(show().stage().posed().shown().pose(0).to.first_line, slots);
}

}  // namespace
}  // namespace throng::app::split_view_test
