// One character alone in the viewer, in the same picture whatever its size, and with its panel beside it.

#include <gtest/gtest.h>

#include "app/settings/times_of_day.h"
#include "tests/golden/golden_picture.h"

namespace throng::app::test::viewer_golden_test {
namespace {

DemoOptions viewed(ContextKind context) {
  DemoOptions options = golden_options(context);
  options.tuning.agents = 4;
  options.view = "walk";
  options.frames = 20;
  return options;
}

class ViewerPicture : public testing::TestWithParam<ContextKind> {};

TEST_P(ViewerPicture, OfAPerson) { expect_golden_picture("viewer", viewed(GetParam())); }

TEST_P(ViewerPicture, HasTheLightThatTheCrowdHas) {
  DemoOptions options = viewed(GetParam());
  options.tuning.light = times_of_day[1].light;
  expect_golden_picture("viewer-evening", options);
}

TEST_P(ViewerPicture, OfFiveCentimetresIsTheSame) {
  DemoOptions options = viewed(GetParam());
  options.placement.scale = 0.05 / 1.8;
  expect_golden_picture("viewer", options);
}

TEST_P(ViewerPicture, OfSeventyNineMetresIsTheSame) {
  DemoOptions options = viewed(GetParam());
  options.placement.scale = 79.0 / 1.8;
  expect_golden_picture("viewer", options);
}

INSTANTIATE_TEST_SUITE_P(Headless, ViewerPicture, testing::Values(ContextKind::egl, ContextKind::osmesa),
                         [](const auto& run) { return run.param == ContextKind::egl ? "Egl" : "OSMesa"; });

TEST(ViewerPanelPicture, HasItsClipsBesideIt) {
  DemoOptions options = viewed(ContextKind::egl);
  options.width = 1280;
  options.height = 720;
  options.ui = true;
  options.ui_fixed = true;
  expect_golden_picture("viewer-panel", options);
}

}  // namespace
}  // namespace throng::app::test::viewer_golden_test
