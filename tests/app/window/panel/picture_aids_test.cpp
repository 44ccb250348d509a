// The legend, the line of a split, ids and figures above heads help to read the picture of the crowd.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::picture_aids_test {
namespace {

bool overlap(const UiRectangle& a, const UiRectangle& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

struct PictureAids : testing::Test {
  UiRectangle place(const std::string& widget) {
    const UiRectangle* const found = driver.find(widget);
    EXPECT_NE(found, nullptr) << widget;
    return found == nullptr ? UiRectangle() : *found;
  }
  std::vector<std::string> heads() const {
    std::vector<std::string> names;
    for (const auto& [name, where] : driver.overlay.ui_map().widgets) {
      if (name.starts_with("head:")) names.push_back(name);
    }
    return names;
  }
  /// 300 heads in a few metres before the camera.
  void show_dense_heads() {
    driver.tuning.inspection.figures_above_heads = true;
    driver.report.camera = {.y = 1.7F, .z = 8};
    driver.report.heads.clear();
    for (std::uint32_t agent = 0; agent < 300; ++agent) {
      driver.report.heads.push_back({.agent = agent,
                                     .x = 0.2F * static_cast<float>(agent % 20) - 2.5F,
                                     .y = 1.9F,
                                     .z = -0.4F * static_cast<float>(agent / 20),
                                     .interval = 1 + static_cast<int>(agent % 8),
                                     .bone_level = static_cast<int>(agent % 4)});
    }
  }
  void drag_line_by(float pixels) {
    const UiRectangle line = place("split line");
    const float x = line.x + line.width / 2, y = line.y + line.height / 3;
    driver.point_at(x, y);
    driver.button(true);
    driver.frames();
    driver.point_at(x + pixels / 2, y + 5);
    driver.frames();
    driver.point_at(x + pixels, y + 9);
    driver.frames();
  }

  OverlayDriver driver;
  LodInspection& look = driver.tuning.inspection;
};

TEST_F(PictureAids, TheLegendStandsAtTheLowerLeftAndIsFolded) {
  EXPECT_FALSE(driver.sees("legend")) << "nothing is coloured";
  driver.tuning.debug_view = DebugView::interval;
  driver.frames();
  const UiRectangle whole = place("legend"), crowd = driver.overlay.crowd_area();
  EXPECT_TRUE(driver.sees("legend:5"));
  EXPECT_LT(whole.x, 20);
  EXPECT_NEAR(whole.y + whole.height, crowd.height, 20);
  driver.click("legend.fold");
  EXPECT_LT(place("legend").height, whole.height / 2);
  EXPECT_FALSE(driver.sees("legend:0"));
  driver.click("legend.fold");
  EXPECT_TRUE(driver.sees("legend:5"));
}

TEST_F(PictureAids, TheLegendAloneSaysTimeAndPeopleAndHidesThePanel) {
  driver.report.seconds = 12.4;
  driver.report.people = 143;
  driver.overlay.show_legend_only();
  driver.frames();
  ASSERT_TRUE(driver.sees("legend"));
  const UiRectangle moment = place("legend");
  EXPECT_FALSE(driver.sees("tab:Crowd"));
  EXPECT_FALSE(driver.sees("legend.fold"));
  EXPECT_EQ(driver.overlay.crowd_area().height, static_cast<float>(driver.overlay.ui_map().height));
  driver.tuning.debug_view = DebugView::speed;
  driver.frames();
  ASSERT_TRUE(driver.sees("legend.ramp"));
  EXPECT_GT(place("legend").height, moment.height);
}

TEST_F(PictureAids, TheLegendIsUnderNoCard) {
  driver.tuning.debug_view = DebugView::error;
  driver.report.selected.emplace();
  driver.report.replay.emplace();
  driver.press(Key::l);
  driver.point_at("Messages.title", 0.5F);
  driver.button(true);
  driver.frames();
  driver.point_at(150, 500);  // to the lower left, where the legend would be
  driver.frames();
  driver.button(false);
  driver.frames();
  ASSERT_GT(place("Messages").y, 300);
  for (const char* const card : {"Selected", "Messages", "Replay"}) {
    EXPECT_FALSE(overlap(place("legend"), place(card))) << card;
  }
}

TEST_F(PictureAids, TheSplitLineIsDraggedInOneChange) {
  EXPECT_FALSE(driver.sees("split line"));
  look.split = Split::shown;
  driver.frames();
  EXPECT_TRUE(driver.sees("split:left"));
  EXPECT_TRUE(driver.sees("split:right"));
  const float before = look.split_at;
  EXPECT_FALSE(driver.overlay.uses_pointer());
  drag_line_by(128);
  EXPECT_TRUE(driver.overlay.uses_pointer()) << "the camera has to leave it alone";
  EXPECT_TRUE(driver.overlay.is_in_a_change());
  driver.button(false);
  EXPECT_FALSE(asks<SelectAt>(driver.frames()));
  EXPECT_FALSE(driver.overlay.is_in_a_change());
  EXPECT_NEAR(look.split_at, before + 0.1F, 1e-3F);
  EXPECT_EQ(look.split, Split::shown);
}

TEST_F(PictureAids, TheSplitLineStaysOverTheCrowd) {
  look.split = Split::difference;
  driver.frames();
  drag_line_by(2000);
  driver.button(false);
  driver.frames();
  EXPECT_NEAR(look.split_at, driver.overlay.crowd_area().width / 1280, 0.01F);
  EXPECT_TRUE(driver.sees("split line"));
  drag_line_by(-3000);
  driver.button(false);
  driver.frames();
  EXPECT_EQ(look.split_at, 0.0F);
  EXPECT_TRUE(driver.sees("split line"));
}

TEST_F(PictureAids, TheSplitLineIsGrabbedSixPixelsBesideIt) {
  look.split = Split::shown;
  driver.frames();
  const float line = look.split_at * 1280;
  for (const float beside : {-6.5F, -5.5F, 5.5F, 6.5F}) {
    driver.point_at(line + beside, 300);
    driver.frames();
    EXPECT_EQ(driver.overlay.uses_pointer(), beside > -6 && beside < 6) << beside;
  }
}

TEST_F(PictureAids, AClickAtTheSplitLineMovesNothing) {
  look.split = Split::shown;
  driver.frames();
  const float before = look.split_at;
  EXPECT_FALSE(asks<SelectAt>(driver.click("split line")));
  EXPECT_EQ(look.split_at, before);
}

TEST_F(PictureAids, FiguresAboveHeadsNeverOverlap) {
  show_dense_heads();
  driver.report.selected.emplace();
  driver.report.selected->agent = 290;
  driver.frames();
  const std::vector<std::string> names = heads();
  EXPECT_GT(names.size(), 20U);
  EXPECT_LT(names.size(), 300U);
  EXPECT_TRUE(driver.sees("head:290")) << "the selected agent's is always there";
  for (std::size_t i = 0; i < names.size(); ++i) {
    const UiRectangle one = place(names[i]);
    for (std::size_t other = 0; other < i; ++other) {
      EXPECT_FALSE(overlap(one, place(names[other]))) << names[i] << " and " << names[other];
    }
    for (const char* const card : {"Selected", "legend", "warning:0"}) EXPECT_FALSE(overlap(one, place(card)));
    EXPECT_LE(one.x + one.width, driver.overlay.crowd_area().width);
  }
}

TEST_F(PictureAids, AnIdStandsAboveAHeadWithItsFigure) {
  driver.tuning.ids = look.figures_above_heads = true;
  driver.report.camera = {.y = 1.7F, .z = 8};
  float narrower = 0;
  for (const char* const id : {"", "7", "pedestrian 7"}) {
    driver.report.heads = {{.agent = 3, .y = 1.9F, .id = id, .interval = 2}};
    driver.frames();
    EXPECT_GT(place("head:3").width, narrower) << id;
    narrower = place("head:3").width;
  }
  driver.report.heads.front().interval = 0;
  driver.frames();
  EXPECT_LT(place("head:3").width, narrower) << "the id alone";
}

TEST_F(PictureAids, IdsAloneStayOverAHiddenPanelAndBesideTheLegend) {
  show_dense_heads();
  driver.overlay.show_legend_only();
  driver.frames();
  EXPECT_TRUE(heads().empty()) << "figures belong to the panel";
  driver.tuning.ids = true;
  driver.frames();
  EXPECT_GT(heads().size(), 20U);
  for (const std::string& name : heads()) EXPECT_FALSE(overlap(place(name), place("legend"))) << name;
  driver.report.viewer.emplace();
  driver.frames();
  EXPECT_TRUE(heads().empty()) << "the crowd waits";
}

TEST_F(PictureAids, OfAnOverlayThatEndsLeaveTheOneOfBeforeInUse) {
  driver.tuning.debug_view = DebugView::interval;
  OverlayDriver().frames();
  driver.frames();
  EXPECT_TRUE(driver.sees("legend"));
}

TEST_F(PictureAids, FiguresAboveHeadsDoNotFlicker) {
  driver.shown_height = 720;  // for which these heads are dense
  show_dense_heads();
  driver.frames();
  const std::vector<std::string> before = heads();
  for (int frame = 0; frame < 10; ++frame) {
    driver.report.camera.x = frame % 2 == 0 ? 0.004F : -0.004F;  // a camera in a hand that trembles
    for (HeadFigures& head : driver.report.heads) {
      head.z += head.agent % 2 == static_cast<std::uint32_t>(frame % 2) ? 0.02F : -0.02F;
    }
    driver.frames(1);
    const std::vector<std::string> now = heads();
    const auto stayed = std::ranges::count_if(
        before, [&](const std::string& name) { return std::ranges::find(now, name) != now.end(); });
    EXPECT_GT(static_cast<double>(stayed), 0.9 * static_cast<double>(before.size())) << frame;
  }
}

}  // namespace
}  // namespace throng::app::picture_aids_test
