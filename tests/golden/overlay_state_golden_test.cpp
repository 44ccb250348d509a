// Cards, lists and states of the overlay, which a person brings about, with nothing but sky behind them.
#include <cstdint>
#include <memory>

#include <gtest/gtest.h>

#include "throng/render/renderer.h"

#include "app/show/camera/fly_camera.h"
#include "tests/app/window/panel/overlay_driver.h"
#include "tests/gl/gl_test.h"
#include "tests/golden/golden_picture.h"

namespace throng::app::test::overlay_state_golden_test {
namespace {

class OverlayState : public render::test::SoftwareGlTest {
 protected:
  void SetUp() override {
    SoftwareGlTest::SetUp();
    auto renderer = render::Renderer::create(context(), {.data = THRONG_SOURCE_DIR, .size = {1280, 720}});
    ASSERT_TRUE(renderer) << renderer.error().message;
    renderer_ = std::move(*renderer);
    ASSERT_TRUE(renderer_->prepare_overlay());
    person.shown_height = 720;  // as the picture
    person.report.notice.clear();
    person.report.context = "egl";
  }
  void TearDown() override {
    renderer_.reset();
    SoftwareGlTest::TearDown();
  }

  void open(const std::string& tab) { person.click("tab:" + tab); }
  /// Holds the overlay as it is now against its golden picture.
  void looks_as_it_did(const std::string& picture) {
    person.frames();
    render::CrowdFrame frame;
    frame.camera = render::view_of(camera_at({.y = 2, .z = 5, .pitch = 35}), 1280.0F / 720.0F);
    frame.light.clouds = 0.0F;
    renderer_->draw(frame);
    renderer_->draw_overlay(*person.overlay.draw_data());
    const PictureOrigin origin =
        origin_of({.context = "egl", .gl_version = context().version(), .gl_renderer = context().renderer()});
    expect_golden_image(picture, picture, renderer_->read_image(), origin);
  }

  OverlayDriver person;

 private:
  std::unique_ptr<render::Renderer> renderer_;
};

TEST_F(OverlayState, HelpThatIsSearched) {
  person.press(Key::f1);
  person.click("Search.field");
  person.type("interval");
  looks_as_it_did("state-help");
}

TEST_F(OverlayState, MessagesSoFarAndWarnings) {
  person.report.notice =
      "No graphics card draws here; the processor does, by llvmpipe. To keep up it starts with 300 agents and no "
      "shadows; "
      "--agents and --shadows change that.\nOne more.";
  person.report.messages.pass(60.0);
  person.report.messages.say("Wrote throng-1.png");
  person.report.messages.say("people.glb: it is neither GLB nor valid JSON", Message::Kind::refused);
  person.press(Key::l);
  looks_as_it_did("state-messages");
}

TEST_F(OverlayState, BadgesOfAllThatLasts) {
  person.report.recording = {.file = "throng-1.rec", .began_at = 0};
  person.report.messages.pass(75.0);
  person.tuning.paused = true;
  LodInspection& look = person.tuning.inspection;
  look.freeze_camera = look.thresholds = true;
  look.forced_interval = 4;
  look.forced_bone_level = 2;
  person.tuning.taken_away.upload = true;
  open("LOD skipping");
  looks_as_it_did("state-badges");
}

TEST_F(OverlayState, ValuesThatAreSearched) {
  person.click("search");
  person.type("error");
  looks_as_it_did("state-search");
}

TEST_F(OverlayState, ValuesWithoutEffectAndThoseThatWereChanged) {
  open("LOD skipping");
  person.tuning.lod.rule = LodRule::distance;
  person.tuning.lod.largest_interval = 4;
  looks_as_it_did("state-distance");
}

TEST_F(OverlayState, TwoTuningsAndWhereTheyDiffer) {
  open("Presets");
  person.click("Copy A to B");
  person.press(Key::b);
  person.tuning.error_px = 4;
  person.tuning.lod.largest_interval = 16;
  looks_as_it_did("state-compare");
}

TEST_F(OverlayState, LegendOfIntervalsAndOfTheSplit) {
  person.tuning.debug_view = DebugView::interval;
  person.tuning.inspection.split = Split::difference;
  looks_as_it_did("state-legend");
}

TEST_F(OverlayState, FiguresAboveHeadsThatDoNotPileUp) {
  person.tuning.inspection.figures_above_heads = true;
  person.report.camera = {.y = 2, .z = 5, .pitch = 35};
  for (std::uint32_t i = 0; i < 60; ++i) {
    const auto place = static_cast<float>(i);
    person.report.heads.push_back({.agent = i,
                                   .x = 0.11F * (place - 30),
                                   .y = 6 + 0.03F * static_cast<float>(i % 7),
                                   .z = -2 - 0.02F * place,
                                   .interval = 1 + static_cast<int>(i) % 8,
                                   .bone_level = static_cast<int>(i) % 3});
  }
  looks_as_it_did("state-heads");
}

TEST_F(OverlayState, ReplayWithItsControls) {
  person.report.replay = ReplayReport{.frame = 40, .frames = 101, .paused = true};
  looks_as_it_did("state-replay");
}

}  // namespace
}  // namespace throng::app::test::overlay_state_golden_test
