// Every tab of the overlay, with figures from a committed report and nothing but sky behind it; and the whole of it on
// a screen with four times the pixels.
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "tests/golden/golden_picture.h"

namespace throng::app::test::overlay_golden_test {
namespace {

struct TabPicture {
  const char* tab;
  const char* picture;
  int scale;
  std::optional<int> selected = std::nullopt;
};

class OverlayPicture : public testing::TestWithParam<TabPicture> {};

TEST_P(OverlayPicture, LooksAsItDid) {
  const TabPicture& picture = GetParam();
  DemoOptions options = golden_options(ContextKind::egl);
  options.width = 1280 * picture.scale;
  options.height = 720 * picture.scale;
  look_at_plain_sky(options);
  options.ui = true;
  options.ui_fixed = true;
  options.ui_tab = picture.tab;
  options.selected = picture.selected;
  options.ui_scale = static_cast<float>(picture.scale);
  expect_golden_picture(picture.picture, options);
}

INSTANTIATE_TEST_SUITE_P(
    Egl, OverlayPicture,
    testing::Values(TabPicture{"LOD skipping", "overlay-skipping", 1}, TabPicture{"Per-bone LOD", "overlay-bones", 1},
                    TabPicture{"Scheduling", "overlay-scheduling", 1}, TabPicture{"Agent", "overlay-agent", 1},
                    TabPicture{"Agent", "overlay-agent-selected", 1, 0}, TabPicture{"Presets", "overlay-presets", 1},
                    TabPicture{"Presets", "overlay-scale-2", 2}),
    [](const auto& run) {
      std::string name = run.param.picture;
      std::erase(name, '-');
      return name;
    });

}  // namespace
}  // namespace throng::app::test::overlay_golden_test
