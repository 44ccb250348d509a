#include "app/show/camera/scenes.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "app/people/crowd/crowd.h"
#include "tests/app/people/crowd/crowd_person.h"

namespace throng::app::scenes_test {
namespace {

// Metres ahead of the camera and to its right, on the ground.
glm::vec2 seen_from(const CameraPose& camera, const glm::vec3& point) {
  const float yaw = camera.yaw * std::numbers::pi_v<float> / 180.0F;
  const glm::vec2 away(point.x - camera.x, point.z - camera.z);
  const glm::vec2 ahead(-std::sin(yaw), -std::cos(yaw));
  return {glm::dot(away, ahead), glm::dot(away, glm::vec2(-ahead.y, ahead.x))};
}

TEST(SceneCameras, EverySceneHasThemAllAndTheFirstIsItsOwn) {
  for (const Scene scene : {Scene::plaza, Scene::parade, Scene::stadium, Scene::grid, Scene::film}) {
    const auto cameras = scene_cameras(scene, 1000, person());
    const auto names = scene_camera_names(scene);
    ASSERT_EQ(cameras.size(), names.size());
    for (std::size_t i = 0; i < cameras.size(); ++i) EXPECT_EQ(cameras[i].name, names[i]);
    for (const char* const name : {"front", "above", "close", "far", "tower"}) {
      EXPECT_NE(find_camera(cameras, name), nullptr) << name;
    }
    EXPECT_EQ(find_camera(cameras, ""), cameras.data());
    EXPECT_EQ(find_camera(cameras, "sideways"), nullptr);
  }
}

TEST(SceneCameras, TheFrontOfThePlazaHasPeopleNearAndACrowdBehindThem) {
  for (const std::uint32_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
    const auto cameras = scene_cameras(Scene::plaza, 1000, person());
    const CameraPose& front = cameras.front().place;
    const Crowd crowd(Scene::plaza, 1000, seed, person());
    float nearest = 1e9F;
    int in_view = 0, distant = 0;
    for (const glm::vec3& position : crowd.positions()) {
      const glm::vec2 seen = seen_from(front, position);
      if (seen.x <= 0.0F || std::abs(seen.y) > 0.68F * seen.x) continue;  // 16:9 at 42 degrees
      ++in_view;
      nearest = std::min(nearest, seen.x);
      if (seen.x > 40.0F) ++distant;
    }
    EXPECT_GT(nearest, 3.5F) << "seed " << seed;
    EXPECT_LT(nearest, 6.0F) << "seed " << seed;
    EXPECT_GT(in_view, 600) << "seed " << seed;
    EXPECT_GT(distant, 200) << "seed " << seed;
  }
}

TEST(SceneCameras, EveryCameraLooksAtSomebodyHoweverSmallTheCrowd) {
  for (const Scene scene : {Scene::plaza, Scene::parade, Scene::stadium, Scene::grid}) {
    for (const std::size_t agents : {1U, 10U, 100U}) {
      const Crowd crowd(scene, agents, 1, person());
      for (const NamedCamera& camera : scene_cameras(scene, agents, person())) {
        int ahead = 0;
        for (const glm::vec3& position : crowd.positions()) {
          const glm::vec2 seen = seen_from(camera.place, position);
          const float right = std::abs(seen.y);
          if (seen.x > 0.5F && right < 0.7F * glm::length(glm::vec2(seen.x, camera.place.y))) ++ahead;
        }
        EXPECT_GT(ahead, 0) << camera.name << " of " << agents;
      }
    }
  }
}

TEST(SceneCameras, GrowWithTheCharacter) {
  CharacterRoles giant = person();
  giant.height = 18.0;
  const auto cameras = scene_cameras(Scene::grid, 100, person()), larger = scene_cameras(Scene::grid, 100, giant);
  for (std::size_t camera = 0; camera < cameras.size(); ++camera) {
    EXPECT_NEAR(larger[camera].place.y, 10.0F * cameras[camera].place.y, 1e-3F);
    EXPECT_EQ(larger[camera].place.yaw, cameras[camera].place.yaw);
  }
}

TEST(SceneCameras, LookAtAnAnimalThatIsLongAndLow) {
  CharacterRoles wolf = person();
  wolf.height = 1.0;
  wolf.radius = 2.0;
  for (const char* const name : {"front", "close"}) {
    const auto cameras = scene_cameras(Scene::grid, 1, wolf);
    const CameraPose& place = find_camera(cameras, name)->place;
    const float seen = place.y + place.z * std::tan(place.pitch * std::numbers::pi_v<float> /
                                                    180.0F);  // where the middle of the picture is
    EXPECT_GT(seen, 0.0F) << name;
    EXPECT_LT(seen, 1.0F) << name;
    EXPECT_LT(place.z, 5.0F * static_cast<float>(wolf.spacing())) << name;
  }
}

}  // namespace
}  // namespace throng::app::scenes_test
