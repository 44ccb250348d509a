// Key F: the camera goes where the whole crowd fills what the panel leaves free.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include "app/show/camera/fly_camera.h"
#include "app/show/camera/scenes.h"
#include "app/show/camera_guide.h"
#include "app/show/crowd_framing.h"
#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"
#include "app/window/window_camera.h"
#include "tests/app/show/recording/recorded_run.h"
#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::framing_test {
namespace {

using namespace std::string_view_literals;

/// Where the crowd is seen, in shares of the free part of the picture: 0 at its left or upper edge, 1 at the others.
struct Seen {
  glm::vec2 low{1e9F}, high{-1e9F};
  float nearest = 1e9F;  // metres ahead of the camera
};

Seen seen_in(const UiRectangle& area, glm::ivec2 size, const Stage& stage, const render::Camera& camera) {
  const glm::vec2 pixels(size);
  const render::CameraView view = render::view_of(camera, pixels.x / pixels.y);
  Seen seen;
  for (const FramedBox& box : boxes_of(stage)) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      const glm::vec3 at((corner & 1U) != 0 ? box.low.x : box.high.x, (corner & 2U) != 0 ? box.low.y : box.high.y,
                         (corner & 4U) != 0 ? box.low.z : box.high.z);
      const glm::vec4 clip = view.projection * view.view * glm::vec4(at, 1.0F);
      EXPECT_GT(clip.w, render::Camera::near_distance) << "too near to be drawn";
      seen.nearest = std::min(seen.nearest, clip.w);
      const glm::vec2 pixel((0.5F + 0.5F * clip.x / clip.w) * pixels.x, (0.5F - 0.5F * clip.y / clip.w) * pixels.y);
      const glm::vec2 share((pixel.x - area.x) / area.width, (pixel.y - area.y) / area.height);
      seen.low = glm::min(seen.low, share);
      seen.high = glm::max(seen.high, share);
    }
  }
  return seen;
}

void expect_filled(const Show& show, const render::Camera& camera, const UiRectangle& area, glm::ivec2 size) {
  const Seen seen = seen_in(area, size, show.stage(), camera);
  EXPECT_GE(seen.low.x, 0.0F);
  EXPECT_GE(seen.low.y, 0.0F);
  EXPECT_LE(seen.high.x, 1.0F);
  EXPECT_LE(seen.high.y, 1.0F);
  const float nearest_edge = std::min({seen.low.x, seen.low.y, 1.0F - seen.high.x, 1.0F - seen.high.y});
  const bool is_as_near_as_it_gets = seen.nearest < 1.1F * render::Camera::near_distance;
  EXPECT_TRUE(nearest_edge < 0.1F || is_as_near_as_it_gets) << "there is room to go nearer: " << nearest_edge;
}

UiRectangle free_area(glm::ivec2 size) {
  OverlayDriver person;
  person.overlay.begin_frame(size.x, size.y, 1.0 / 60, {});
  person.overlay.build(person.report, person.tuning);
  return person.overlay.crowd_area();
}

void expect_framed(Show& show) {
  for (const glm::ivec2 size : {glm::ivec2(1280, 720), {2560, 1440}, {600, 400}, {500, 1200}}) {
    SCOPED_TRACE(std::to_string(size.x) + "x" + std::to_string(size.y));
    const UiRectangle area = free_area(size);
    show.view().width = size.x;
    show.view().height = size.y;
    for (const float turned : {0.0F, 1.0F, 4.0F}) {
      for (const float pitch : {-0.1F, -0.5F, -1.4F}) {
        WindowCamera camera(show);
        camera.put({.x = 3, .y = 2, .z = 5, .yaw = 57.3F * turned, .pitch = 57.3F * pitch}, show);
        const render::Camera before = camera.camera();
        camera.see_beside(area, size, show);
        camera.frame_crowd(show);
        EXPECT_EQ(camera.camera().yaw, before.yaw);
        EXPECT_EQ(camera.camera().pitch, before.pitch);
        expect_filled(show, camera.camera(), area, size);
      }
    }
  }
}

TEST(Framing, FillsTheFreePartOfThePictureWithEachScene) {
  for (const char* const scene : {"plaza", "parade", "stadium", "grid"}) {
    SCOPED_TRACE(scene);
    expect_framed(*test::show_of(test::demo("--agents 300 --scene " + std::string(scene))));
  }
}

TEST(Framing, FillsItWithOneAgent) { expect_framed(*test::show_of(test::demo("--agents 1"))); }

TEST(Framing, HoldsAllThatAnAgentAnimates) {
  const auto show = test::show_of(test::demo("--agents 1"));
  const FramedBox box = boxes_of(show->stage()).front();
  const anim::CharacterBounds& bounds = show->stage().people().front().character->bounds;
  const float scale = show->stage().crowd().scales().front();
  const auto reach = scale * static_cast<float>(bounds.reach), tall = scale * static_cast<float>(bounds.height);
  EXPECT_GE(box.high.y - box.low.y, 0.5F * tall + reach - 1e-4F) << "arms that wave are above the head";
  EXPECT_GE(box.high.x - box.low.x, 2.0F * reach - 1e-4F);
}

TEST(Framing, FillsItWithCharactersOfFiveCentimetres) {
  for (const char* const agents : {"1", "20"}) {
    SCOPED_TRACE(agents);
    const auto show = test::show_of(test::demo("--agents " + std::string(agents)));
    ASSERT_TRUE(show->take(SetPlacement{0, {.scale = 0.028}}));
    const FramedBox box = boxes_of(show->stage()).front();
    ASSERT_LT(box.high.y - box.low.y, 0.08F) << "arms reach above the head";
    expect_framed(*show);
  }
}

TEST(Framing, FillsItWithAgentsOfSeventyNineMetres) {
  const auto show = test::show_of(test::demo("--agents 20"));
  ASSERT_TRUE(show->take(SetPlacement{0, {.scale = 44}}));
  ASSERT_GT(boxes_of(show->stage()).front().high.y, 60.0F);
  expect_framed(*show);
}

/// A window with people, one frame after another.
class CrowdOfAnotherSize : public testing::Test {
 protected:
  void make_people(double times) { ASSERT_TRUE(show_->take(SetPlacement{0, {.scale = times}})); }
  void frame() {
    camera_.hand_over(*show_);
    show_->animate(test::sixtieth);
    camera_.take_back(*show_);
  }

  const std::unique_ptr<Show> show_ = test::show_of(test::demo("--agents 20"));
  WindowCamera camera_{*show_};
};

TEST_F(CrowdOfAnotherSize, IsSeenWhole) {
  const glm::ivec2 size(1280, 720);
  const UiRectangle area = free_area(size);
  show_->view().width = size.x;
  show_->view().height = size.y;
  camera_.see_beside(area, size, *show_);
  for (const double times : {4.0, 1.0, 0.1}) {
    camera_.put({.x = 1, .y = 90, .z = 3, .yaw = 100, .pitch = 70}, *show_);
    frame();
    make_people(times);
    frame();
    expect_filled(*show_, camera_.camera(), area, size);
  }
}

TEST_F(CrowdOfAnotherSize, LeavesTheCameraWhereItIsAboutAsLargeOrThePersonPutsIt) {
  frame();
  const render::Camera before = camera_.camera();
  make_people(1.05);
  frame();
  EXPECT_EQ(camera_.camera(), before);
  const CameraPose place{.x = 1, .y = 2, .z = 3};
  make_people(4.0);
  camera_.put(place, *show_);
  frame();
  frame();
  EXPECT_EQ(camera_.camera(), camera_at(place));
}

TEST_F(CrowdOfAnotherSize, LeavesACameraThatFollowsAnAgent) {
  ASSERT_TRUE(show_->take(Select{3}));
  camera_.take(ToggleFollow{}, *show_);
  frame();
  const render::Camera before = camera_.camera();
  make_people(4.0);
  camera_.hand_over(*show_);
  EXPECT_EQ(camera_.camera(), before);
}

class CamerasOfARecordedCrowd : public test::TemporaryFolder {
 protected:
  /// People who walk along a street of 60 m, which is 20 m wide.
  std::unique_ptr<Show> recorded(double length = 60.0) const {
    const std::filesystem::path walk = folder_ / "walk.csv";
    std::ofstream file(walk);
    file << "id,time,x,y\n";
    for (const int second : {0, 40}) {
      for (int person = 0; person <= 10; ++person) {
        file << person << ',' << second << ',' << length * second / 40 << ',' << 2 * person << '\n';
      }
    }
    file.close();
    return test::show_of(test::demo("--trajectories " + walk.string()));
  }
  static bool is_among_people(std::size_t camera) { return scene_camera_names(Scene::tracks)[camera] == "close"sv; }
};

TEST_F(CamerasOfARecordedCrowd, SeeAllOfItBesideThePanel) {
  const auto show = recorded();
  for (const glm::ivec2 size : {glm::ivec2(1280, 720), {600, 400}, {500, 1200}}) {
    show->view().width = size.x;
    show->view().height = size.y;
    WindowCamera camera(*show);
    camera.see_beside(free_area(size), size, *show);
    for (std::size_t i = 0; i < scene_camera_names(Scene::tracks).size(); ++i) {
      if (is_among_people(i)) continue;
      SCOPED_TRACE(std::string(scene_camera_names(Scene::tracks)[i]) + " in " + std::to_string(size.x));
      camera.take(GoToCamera{i}, *show);
      expect_filled(*show, camera.camera(), free_area(size), size);
    }
    camera.take(GoHome{}, *show);
    expect_filled(*show, camera.camera(), free_area(size), size);
  }
}

TEST_F(CamerasOfARecordedCrowd, StayWhereOnlyTheBodiesOfPeopleChange) {
  const auto show = recorded();
  WindowCamera camera(*show);
  const render::Camera before = camera.camera();
  ASSERT_TRUE(show->take(SetPlacement{0, {.scale = 4}}));
  camera.hand_over(*show);
  EXPECT_EQ(camera.camera(), before);
}

TEST_F(CamerasOfARecordedCrowd, BeginBesideThePanelToo) {
  const auto show = recorded();
  const glm::ivec2 size(show->view().width, show->view().height);
  WindowCamera camera(*show);
  camera.see_beside(free_area(size), size, *show);
  expect_filled(*show, camera.camera(), free_area(size), size);
  camera.put({.x = 1, .y = 2, .z = 3}, *show);
  const render::Camera put = camera.camera();
  camera.see_beside(free_area(size), size, *show);
  EXPECT_EQ(camera.camera(), put) << "a person has moved it";
}

TEST_F(CamerasOfARecordedCrowd, LeaveACameraAloneThatAPersonChose) {
  auto options = test::demo("--trajectories " + (folder_ / "walk.csv").string() + " --camera 1,2,3,40,-5,70");
  recorded();
  const auto show = test::show_of(options);
  WindowCamera camera(*show);
  const render::Camera before = camera.camera();
  camera.see_beside(free_area({1280, 720}), {1280, 720}, *show);
  EXPECT_EQ(camera.camera(), before);
}

// A plan of field tools has none at all.
TEST_F(CamerasOfARecordedCrowd, LookAtItFromTheTopWithHardlyAnyPerspective) {
  for (const double length : {10.0, 60.0, 3000.0}) {
    const auto show = recorded(length);
    const std::vector<NamedCamera> cameras = cameras_of(show->stage(), 16.0F / 9.0F);
    const NamedCamera& top = *find_camera(cameras, "top");
    EXPECT_LT(top.place.pitch, -88.0F);
    EXPECT_LE(top.place.y, 0.51F * render::Camera::far_distance) << "all of it is drawn";
    if (length > 100.0) continue;
    const float lean = 1.8F * std::tan(glm::radians(0.5F * top.place.field_of_view));
    EXPECT_LT(lean, 0.08F) << "metres of a person of 1.8 m, at the upper edge";
  }
}

}  // namespace
}  // namespace throng::app::framing_test
