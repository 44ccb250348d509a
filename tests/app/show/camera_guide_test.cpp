#include "app/show/camera_guide.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "app/show/camera/fly_camera.h"
#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::camera_guide_test {
namespace {

using test::change;
using test::demo;
using test::show_of;
using test::sixtieth;

void go_to(Show& show, Scene scene) {
  change(show, [&](Tuning& tuning) { tuning.scene = scene; });
  show.animate(sixtieth);
}

TEST(CameraOfAShow, IsTheFilmsOwnWithItsFieldOfViewOnceTheFilmIsChosen) {
  const auto show = show_of(demo("--agents 12"));
  show->animate(sixtieth);
  ASSERT_NE(show->view().camera.vertical_view, glm::radians(film_field_of_view));
  go_to(*show, Scene::film);
  EXPECT_EQ(show->view().camera, show->stage().animated().cut_scene()->film());
  EXPECT_EQ(show->view().camera.vertical_view, glm::radians(film_field_of_view));
}

TEST(CameraOfAShow, BeginsEverySceneWhereThatScenesFirstCameraIs) {
  const auto show = show_of(demo("--agents 12 --camera 1,2,3,40,-5,70"));
  for (const Scene scene : {Scene::grid, Scene::film, Scene::plaza, Scene::stadium, Scene::parade}) {
    go_to(*show, scene);
    if (scene == Scene::film) continue;
    EXPECT_EQ(show->view().camera, camera_at(cameras_of(show->stage()).front().place)) << static_cast<int>(scene);
  }
}

TEST(CameraOfAShow, StaysWhereItIsWhenAnotherValueChanges) {
  const auto show = show_of(demo("--agents 12 --camera 1,2,3,40,-5,70"));
  const render::Camera before = show->view().camera;
  change(*show, [](Tuning& tuning) { tuning.agents = 30; });
  show->animate(sixtieth);
  EXPECT_EQ(show->view().camera, before);
}

class CameraThatFollows : public testing::Test {
 protected:
  void SetUp() override {
    show_->animate(sixtieth);
    show_->view().films = false;
    EXPECT_TRUE(show_->take(Select{0}));  // the first agents walk
    show_->view().guide.follow(true);
    show_->animate(sixtieth);
  }
  glm::vec3 offset() const { return show_->view().camera.position - show_->stage().crowd().positions()[0]; }
  void pass() {
    for (int frame = 0; frame < 300; ++frame) show_->animate(sixtieth);
  }

  const std::unique_ptr<Show> show_ = show_of(demo("--agents 12"));
};

TEST_F(CameraThatFollows, KeepsItsOffsetToTheSelectedAgent) {
  const glm::vec3 offset_before = offset(), place_before = show_->view().camera.position;
  const float yaw_before = show_->view().camera.yaw;
  pass();
  EXPECT_LT(glm::distance(offset(), offset_before), 1e-3F);
  EXPECT_GT(glm::distance(show_->view().camera.position, place_before), 0.5F) << "agent 0 walks";
  EXPECT_EQ(show_->view().camera.yaw, yaw_before);
}

TEST_F(CameraThatFollows, GoesOnWithAnotherAgentFromWhereItIs) {
  const glm::vec3 before = show_->view().camera.position;
  EXPECT_TRUE(show_->take(Select{1}));
  show_->animate(sixtieth);
  EXPECT_LT(glm::distance(show_->view().camera.position, before), 0.2F);
  EXPECT_TRUE(show_->view().guide.follows());
}

TEST_F(CameraThatFollows, StaysOnceNobodyIsSelected) {
  EXPECT_TRUE(show_->take(Select{}));
  show_->animate(sixtieth);
  const glm::vec3 before = show_->view().camera.position;
  pass();
  EXPECT_EQ(show_->view().camera.position, before);
  EXPECT_FALSE(show_->view().guide.follows());
}

}  // namespace
}  // namespace throng::app::camera_guide_test
