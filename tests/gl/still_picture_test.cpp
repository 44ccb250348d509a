// A picture as a file, larger and in better quality than the one in a window.
#include "app/window/still_picture.h"

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "app/output/regression/compare.h"
#include "app/show/opened_show.h"
#include "app/show/painter.h"
#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"
#include "app/window/demo.h"
#include "app/window/drawn_overlay.h"
#include "tests/app/temporary_folder.h"
#include "tests/gl/picture_tolerance.h"
#include "tests/gl/small_picture.h"

namespace throng::app::still_picture_test {
namespace {

testing::AssertionResult are_the_same(const render::Image& a, const render::Image& b) {
  const PictureDifference difference = render::test::measure_difference(a, b).value();
  const bool same = render::test::looks_the_same(difference);
  return (same ? testing::AssertionSuccess() : testing::AssertionFailure())
         << "mean " << difference.mean << ", worst block " << difference.worst_block << " at "
         << difference.worst_block_x << ", " << difference.worst_block_y;
}

constexpr int width = 160, height = 90, frames = 5;

/// A show that is drawn live by a processor, as in a window: without multisampling, shadows and exact light.
class StillPicture : public test::TemporaryFolder {
 protected:
  void SetUp() override { open(); }
  void open() {
    DemoOptions options = of_size(1);
    options.draw = DrawWhich::all;
    StartError error;
    show_ = open_show(options, error);
    ASSERT_NE(show_, nullptr) << error.message;
    for (int frame = 0; frame < frames; ++frame) show_->animate(to_ticks(usual_frame_seconds));
    ASSERT_TRUE(show_->draw());
  }

  static DemoOptions of_size(int times) {
    DemoOptions options = picture_by_processor(times * width, times * height);
    options.tuning.agents = 60;
    options.tuning.lod.rule = LodRule::off;  // all poses are of this moment
    options.frames = frames;
    return options;
  }
  /// Writes a still and reads it.
  render::Image still(int times, const Tuning& values, bool is_replay = false) {
    const std::string file = folder_ / "still.png";
    const Status written = write_still(
        *show_, file, size_of_still(*show_, times), values, is_replay,
        [times](Show& show) { return show.stage().tuning().ids ? DrawnOverlay(of_size(times)).draw(show) : Done{}; });
    EXPECT_TRUE(written) << written.error().message;
    const auto image = render::read_png(file);
    EXPECT_TRUE(image);
    return image ? *image : render::Image::blank(1, 1);
  }
  /// Returns the picture that a run without a window writes of that moment.
  render::Image screenshot(int times, bool ids = false) const {
    DemoOptions options = of_size(times);
    options.tuning.ids = ids;
    options.screenshot = folder_ / "screenshot.png";
    EXPECT_EQ(run_demo(options), 0);
    return render::read_png(options.screenshot).value();
  }
  render::Image picture() {
    EXPECT_TRUE(show_->draw());
    return show_->painter().renderer().read_image();
  }

  std::unique_ptr<Show> show_;
};

TEST_F(StillPicture, IsTheScreenshotOfARunWithoutAWindow) {
  show_.reset();  // one context at a time
  const render::Image wanted = screenshot(2), wanted_in_the_window = screenshot(1);
  open();
  EXPECT_FALSE(are_the_same(wanted_in_the_window, picture()))
      << "a live picture is worse, so that this test tells something";
  const render::Image drawn = still(2, of_size(2).tuning);
  ASSERT_EQ(drawn.width, 2 * width);
  ASSERT_EQ(drawn.height, 2 * height);
  EXPECT_TRUE(are_the_same(wanted, drawn));
}

TEST_F(StillPicture, HasIdsAboveHeadsAsTheScreenshotHas) {
  show_.reset();
  const render::Image wanted = screenshot(2, true);
  open();
  Tuning values = of_size(2).tuning;
  EXPECT_FALSE(are_the_same(wanted, still(2, values)));
  values.ids = true;
  EXPECT_TRUE(are_the_same(wanted, still(2, values)));
}

TEST_F(StillPicture, LeavesThePictureOfTheWindowAsItWas) {
  show_->animate(Ticks{});
  const Tuning values = show_->stage().tuning();
  const render::Image before = picture();
  still(3, of_size(3).tuning);
  EXPECT_EQ(show_->stage().tuning(), values);
  EXPECT_EQ(show_->view().width, width);
  show_->animate(Ticks{});
  const render::Image after = picture();
  ASSERT_EQ(after.width, width);
  EXPECT_TRUE(are_the_same(before, after));
}

TEST_F(StillPicture, OfAReplayShowsThePosesThatWereRecorded) {
  const std::uint64_t frame = show_->stage().posed().frame();
  const Tuning recorded = show_->stage().tuning();
  EXPECT_EQ(still(2, of_size(2).tuning, true).width, 2 * width);
  EXPECT_EQ(show_->stage().posed().frame(), frame);
  EXPECT_EQ(show_->stage().tuning(), recorded);
}

TEST_F(StillPicture, ThatCannotBeWrittenIsNamedAndChangesNothing) {
  const Tuning values = show_->stage().tuning();
  const Status written = write_still(*show_, folder_ / "none" / "still.png", {320, 180}, of_size(2).tuning, false,
                                     [](Show&) { return Done{}; });
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().message.find("still.png"), std::string::npos);
  EXPECT_EQ(show_->stage().tuning(), values);
  EXPECT_EQ(picture().width, width);
}

}  // namespace
}  // namespace throng::app::still_picture_test
