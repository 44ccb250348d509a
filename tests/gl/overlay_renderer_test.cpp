#include "engine/render/passes/overlay_renderer.h"

#include <algorithm>
#include <cstdlib>
#include <memory>

#include <gtest/gtest.h>
#include <imgui/imgui.h>

#include "tests/gl/doll_crowd.h"
#include "tests/gl/gl_test.h"

namespace throng::render::test::overlay_renderer_test {
namespace {

constexpr ImU32 orange = IM_COL32(255, 128, 64, 255);

/// Has an ImGui context of its own, over a picture of the ground.
class Overlay : public SoftwareGlTest {
 protected:
  void SetUp() override {
    SoftwareGlTest::SetUp();
    crowd_ = std::make_unique<DollCrowd>(context());
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().DisplaySize = {DollCrowd::width, DollCrowd::height};
    ASSERT_TRUE(crowd_->renderer().prepare_overlay());
    before_ = crowd_->picture();
  }
  void TearDown() override {
    ImGui::DestroyContext();
    crowd_.reset();
    SoftwareGlTest::TearDown();
  }

  /// Draws the picture with `paint` over it.
  template <typename Paint>
  Image painted(Paint paint) {
    ImGui::NewFrame();
    paint(*ImGui::GetForegroundDrawList());
    ImGui::Render();
    crowd_->renderer().draw_overlay(*ImGui::GetDrawData());
    return crowd_->renderer().read_image();
  }

  const Image& before() const { return before_; }
  Renderer& renderer() { return crowd_->renderer(); }
  void draw_again() { crowd_->renderer().draw(crowd_->frame()); }

 private:
  std::unique_ptr<DollCrowd> crowd_;
  Image before_;
};

void expect_color(const Image& image, int x, int y, ImU32 color) {
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_EQ(image.pixel(x, y)[channel], (color >> (8 * channel)) & 0xFFU) << x << ' ' << y << ' ' << channel;
  }
}

TEST_F(Overlay, ShowsColorsUnconvertedAtTheirPlace) {
  const Image image = painted([](ImDrawList& list) { list.AddRectFilled({20, 10}, {60, 30}, orange); });
  expect_color(image, 40, 20, orange);
  expect_color(image, 21, 11, orange);
  expect_color(image, 58, 28, orange);
  EXPECT_EQ(std::vector(image.pixel(62, 20), image.pixel(63, 20)),
            std::vector(before().pixel(62, 20), before().pixel(63, 20)));
  EXPECT_EQ(std::vector(image.pixel(40, 33), image.pixel(41, 33)),
            std::vector(before().pixel(40, 33), before().pixel(41, 33)));
}

TEST_F(Overlay, BlendsByAlpha) {
  const Image image = painted([](ImDrawList& list) {
    list.AddRectFilled({20, 10}, {60, 30}, IM_COL32(255, 255, 255, 128));
  });
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(image.pixel(40, 20)[channel], (before().pixel(40, 20)[channel] + 255) / 2, 2);
  }
}

TEST_F(Overlay, CutsAtClipRectangles) {
  const Image image = painted([](ImDrawList& list) {
    list.PushClipRect({30, 0}, {50, 100});
    list.AddRectFilled({20, 10}, {60, 30}, orange);
    list.PopClipRect();
  });
  expect_color(image, 30, 20, orange);
  expect_color(image, 49, 20, orange);
  EXPECT_EQ(image.pixel(29, 20)[0], before().pixel(29, 20)[0]);
  EXPECT_EQ(image.pixel(50, 20)[0], before().pixel(50, 20)[0]);
}

TEST_F(Overlay, WritesText) {
  const Image image = painted([](ImDrawList& list) { list.AddText({100, 100}, orange, "Throng"); });
  int lettered = 0;
  for (int y = 100; y < 115; ++y) {
    for (int x = 100; x < 145; ++x) lettered += image.pixel(x, y)[0] == 255 && image.pixel(x, y)[2] == 64 ? 1 : 0;
  }
  EXPECT_GT(lettered, 40);
}

TEST_F(Overlay, IsSharpOverAPictureThatIsStretched) {
  ASSERT_TRUE(renderer().set_size(renderer().size(), renderer().size() / 4));
  draw_again();
  const Image image = painted([](ImDrawList& list) { list.AddRectFilled({20, 10}, {61, 31}, orange); });
  EXPECT_EQ(image.width, DollCrowd::width);
  expect_color(image, 60, 30, orange);
  expect_color(image, 20, 10, orange);
  EXPECT_NE(image.pixel(61, 20)[2], 64);
  int apart = 0;
  for (int x = 0; x < image.width; ++x) apart += std::abs(image.pixel(x, 150)[0] - before().pixel(x, 150)[0]);
  EXPECT_LT(apart, 6 * image.width) << "the ground is where it was, but for its edges";
}

TEST_F(Overlay, LeavesNothingOfItselfInAStretchedPictureThatStays) {
  ASSERT_TRUE(renderer().set_size(renderer().size(), renderer().size() / 2));
  draw_again();
  const Image clean = painted([](ImDrawList&) {});
  painted([](ImDrawList& list) { list.AddRectFilled({20, 10}, {60, 30}, orange); });
  EXPECT_EQ(painted([](ImDrawList&) {}).rgba, clean.rgba);
}

TEST_F(Overlay, IsBesideThePartThatIsStretched) {
  constexpr ImU32 around = IM_COL32(16, 28, 40, 255);
  ASSERT_TRUE(renderer().set_size(renderer().size(), renderer().size() / 3));
  renderer().draw_only({{0, 40}, {200, DollCrowd::height - 40}}, around);
  draw_again();
  const Image image = painted([](ImDrawList&) {});
  expect_color(image, 200, 70, around);
  expect_color(image, 100, DollCrowd::height - 40, around);
  const std::uint8_t* const edge = image.pixel(199, 100);
  EXPECT_NEAR(edge[0], before().pixel(199, 100)[0], 24) << "no colour from around it";
}

TEST_F(Overlay, HonoursVertexOffsetsBeyondSixteenBits) {
  const Image image = painted([](ImDrawList& list) {
    for (int i = 0; i < 20'000; ++i) list.AddRectFilled({0, 0}, {2, 2}, IM_COL32(0, 0, 0, 255));
    list.AddRectFilled({200, 100}, {240, 140}, orange);
  });
  expect_color(image, 220, 120, orange);
}

}  // namespace
}  // namespace throng::render::test::overlay_renderer_test
