#include "app/window/window_camera.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "app/show/camera_guide.h"
#include "app/show/report/frame_report.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::window_camera_test {
namespace {

using test::demo;
using test::show_of;
using test::sixtieth;

class CameraOfAWindow : public testing::Test {
 protected:
  /// Lets a frame pass in which the person asks for that.
  void frame(const std::optional<CameraRequest>& request = {}, const InputFrame& input = {}) {
    camera_.steer(*show_, input, {}, 1.0F / 60);
    if (request) camera_.take(*request, *show_);
    pass();
  }
  void pass() {
    camera_.hand_over(*show_);
    show_->animate(sixtieth);
    camera_.take_back(*show_);
  }
  void go_to(Scene scene) {
    test::change(*show_, [&](Tuning& tuning) { tuning.scene = scene; });
  }
  CameraReport report() const {
    CameraReport report;
    report_cameras(*show_, report);
    camera_.report(report);
    return report;
  }
  render::Camera named(std::size_t camera) const { return camera_at(cameras_of(show_->stage())[camera].place); }

  const std::unique_ptr<Show> show_ = show_of(demo("--agents 12"));
  WindowCamera camera_{*show_};
};

InputFrame flying() {
  InputFrame input;
  input.keys_down.set(static_cast<std::size_t>(Key::w));
  return input;
}

InputFrame dragging(MouseButton button, bool alt) {
  InputFrame input;
  input.buttons_down.set(static_cast<std::size_t>(button));
  input.keys_down[static_cast<std::size_t>(Key::alt)] = alt;
  input.moved_x = 40;
  input.moved_y = -10;
  return input;
}

TEST_F(CameraOfAWindow, IsThatOfTheSceneThatWasChosen) {
  go_to(Scene::grid);
  frame();
  EXPECT_EQ(camera_.camera(), named(0));
}

TEST_F(CameraOfAWindow, IsThatOfThePresetWhoseSceneWasChosen) {
  const CameraPose place{.x = 3, .y = 2, .z = 9, .yaw = 10, .pitch = -5, .field_of_view = 33};
  for (const Scene scene : {Scene::grid, Scene::film}) {
    camera_.put(place, *show_);
    go_to(scene);
    pass();
    EXPECT_EQ(camera_.camera(), camera_at(place));
  }
  go_to(Scene::stadium);
  pass();
  EXPECT_EQ(camera_.camera(), named(0)) << "that was said for one scene alone";
}

TEST_F(CameraOfAWindow, IsTakenFromTheFilmByFlyingAndGivenBackAtHome) {
  go_to(Scene::film);
  frame();
  EXPECT_TRUE(report().films);
  EXPECT_EQ(camera_.camera(), show_->stage().animated().cut_scene()->film());
  frame({}, flying());
  EXPECT_FALSE(report().films);
  EXPECT_TRUE(report().can_film);
  EXPECT_NE(camera_.camera(), show_->stage().animated().cut_scene()->film());
  frame(GoToCamera{1});
  frame(GoHome{});
  EXPECT_TRUE(report().films);
  EXPECT_EQ(camera_.camera(), show_->stage().animated().cut_scene()->film()) << "its field of view too";
}

TEST_F(CameraOfAWindow, GoesHomeAndToTheNamedCamerasOfTheScene) {
  for (std::size_t i = scene_camera_names(Scene::plaza).size(); i-- > 0;) {
    frame(GoToCamera{i});
    EXPECT_EQ(camera_.camera(), named(i)) << i;
  }
  frame({}, flying());
  EXPECT_NE(camera_.camera(), named(0));
  frame(GoHome{});
  EXPECT_EQ(camera_.camera(), named(0));
}

TEST_F(CameraOfAWindow, GoesBackToPlacesThatWereKept) {
  frame(GoToCamera{2});
  frame(KeepBookmark{4});
  EXPECT_TRUE(report().kept[4]);
  EXPECT_FALSE(report().kept[3]);
  frame(GoHome{});
  frame(GoToBookmark{3});
  EXPECT_EQ(camera_.camera(), named(0)) << "nothing was kept there";
  frame(GoToBookmark{4});
  EXPECT_LT(glm::distance(camera_.camera().position, named(2).position), 1e-4F);
  EXPECT_NEAR(camera_.camera().yaw, named(2).yaw, 1e-5F);
}

TEST_F(CameraOfAWindow, TurnsAboutTheCrowdOrTheSelectedAgent) {
  const auto distance_to = [&](const glm::vec3& point) { return glm::distance(camera_.camera().position, point); };
  const glm::vec3 middle = middle_of(show_->stage().crowd());
  const float before = distance_to(middle), yaw = camera_.camera().yaw;
  camera_.steer(*show_, dragging(MouseButton::middle, false), {}, 0);
  EXPECT_NEAR(distance_to(middle), before, 1e-3F);
  EXPECT_LT(camera_.camera().yaw, yaw);

  EXPECT_TRUE(show_->take(Select{7}));
  const UprightBody body = body_of(show_->stage(), 7);
  const glm::vec3 chest = body.foot + glm::vec3(0.0F, 0.5F * body.height, 0.0F);
  const float from_agent = distance_to(chest);
  camera_.steer(*show_, dragging(MouseButton::left, true), {}, 0);
  EXPECT_NEAR(distance_to(chest), from_agent, 1e-3F);
  EXPECT_GT(std::abs(distance_to(middle) - before), 1e-4F);

  const render::Camera here = camera_.camera();
  camera_.steer(*show_, dragging(MouseButton::left, false), {}, 0);
  EXPECT_EQ(camera_.camera(), here) << "a drag without Alt selects";
}

TEST_F(CameraOfAWindow, FollowsTheSelectedAgentUntilAskedAgain) {
  EXPECT_TRUE(show_->take(Select{0}));
  frame(ToggleFollow{});
  EXPECT_TRUE(report().follows);
  const glm::vec3 offset = camera_.camera().position - show_->stage().crowd().positions()[0];
  for (int i = 0; i < 60; ++i) frame();
  EXPECT_LT(glm::distance(camera_.camera().position - show_->stage().crowd().positions()[0], offset), 1e-3F);
  frame(ToggleFollow{});
  EXPECT_FALSE(report().follows);
}

TEST_F(CameraOfAWindow, FliesAtItsSpeed) {
  frame(SetFlySpeed{20.0F});
  EXPECT_EQ(report().fly_speed, 20.0F);
  const glm::vec3 before = camera_.camera().position;
  camera_.steer(*show_, flying(), {}, 0.5F);
  EXPECT_NEAR(glm::distance(camera_.camera().position, before), 10.0F, 1e-3F);
}

TEST_F(CameraOfAWindow, FramesASingleAgentFromOutside) {
  test::change(*show_, [](Tuning& tuning) { tuning.agents = 1; });
  camera_.frame_crowd(*show_);
  EXPECT_GT(glm::distance(camera_.camera().position, show_->stage().crowd().positions()[0]), 1.5F);
}

TEST_F(CameraOfAWindow, TakesThePlacesThatAFileHasKept) {
  frame(KeepBookmark{0});
  CameraBookmarks kept;
  kept[2] = CameraPose{.x = 7};
  camera_.take_bookmarks(kept);
  EXPECT_FALSE(report().kept[0]) << "that of the crowd before";
  frame(GoToBookmark{2});
  EXPECT_EQ(camera_.place().x, 7);
  EXPECT_EQ(camera_.bookmarks(), kept);
}

}  // namespace
}  // namespace throng::app::window_camera_test
