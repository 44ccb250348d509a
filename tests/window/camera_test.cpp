// The cameras of a window, by keys and clicks.
#include <cmath>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "app/character/source.h"
#include "app/people/crowd/crowd.h"
#include "app/show/camera/fly_camera.h"
#include "tests/window/window_driver.h"

namespace throng::app::camera_test {
namespace {

using Json = nlohmann::json;

class CamerasOfAWindow : public WindowDriver {
 protected:
  std::vector<std::string> options() const override {
    return {"--agents", "50", "--scene", "grid", "--size", "1280x720"};
  }
  void go_to(const std::string& scene) {
    click("Scene:" + scene);
    wait_for(scene, [&](const Json& map) { return map["tuning"]["scene"] == scene; });
    next_map();
  }
  bool films() { return next_map()["report"]["cameras"]["films"]; }
  double field_of_view() { return next_map()["camera"]["field_of_view"]; }
};

render::CameraView view_in(const Json& map) {
  const Json& camera = map["camera"];
  const CameraPose place{.x = camera["x"],
                         .y = camera["y"],
                         .z = camera["z"],
                         .yaw = camera["yaw"],
                         .pitch = camera["pitch"],
                         .field_of_view = camera["field_of_view"]};
  return render::view_of(camera_at(place), map["size"][0].get<float>() / map["size"][1].get<float>());
}

/// Expects all agents of the grid of 50 to be seen left of and above a place of the picture, in pixels.
void expect_all_within(const Json& map, float right, float bottom) {
  const auto person = load_character(THRONG_SOURCE_DIR "/assets/mannequin.glb", "person");
  ASSERT_TRUE(person);
  const Crowd crowd(Scene::grid, 50, 1, person->roles);
  const render::CameraView view = view_in(map);
  for (const glm::vec3& foot : crowd.positions()) {
    const glm::vec4 clip = view.projection * view.view * glm::vec4(foot, 1.0F);
    EXPECT_GT(clip.w, 0.0F);
    const float x = (0.5F + 0.5F * clip.x / clip.w) * map["size"][0].get<float>();
    const float y = (0.5F - 0.5F * clip.y / clip.w) * map["size"][1].get<float>();
    EXPECT_TRUE(x >= 0 && y >= 0 && x <= right && y <= bottom) << x << ", " << y;
  }
}

TEST_F(CamerasOfAWindow, FrameTheCrowdBesideThePanel) {
  for (const glm::ivec2 size : {glm::ivec2(1280, 720), {800, 600}}) {
    xdotool({"search", "--name", "^Throng$", "windowsize", std::to_string(size.x), std::to_string(size.y)});
    wait_for("its size", [&](const Json& map) { return map["size"] == Json::array({size.x, size.y}); });
    press("f");
    const Json map = next_map();
    const Json column = map["widgets"]["tab:Crowd"], strip = map["widgets"]["Frame graph"];
    expect_all_within(map, column["x"], strip["y"]);
  }
  press("Tab");
  press("f");
  const Json map = next_map();
  ASSERT_TRUE(map["hidden"]);
  expect_all_within(map, 800, 600);
}

TEST_F(CamerasOfAWindow, AreThoseOfTheSceneThatIsChosen) {
  const Json grid = next_map()["camera"];
  go_to("film");
  EXPECT_TRUE(films());
  EXPECT_NEAR(field_of_view(), 50, 0.01);
  go_to("plaza");
  EXPECT_FALSE(films());
  EXPECT_NEAR(field_of_view(), 42, 0.01);
  go_to("grid");
  EXPECT_EQ(next_map()["camera"], grid);
}

TEST_F(CamerasOfAWindow, AreTakenFromTheFilmByFlyingAndGivenBackByHome) {
  go_to("film");
  press("w");
  EXPECT_FALSE(films());
  press("Home");
  EXPECT_TRUE(films());
}

TEST_F(CamerasOfAWindow, AreKeptUnderADigit) {
  const Json before = next_map()["camera"];
  xdotool({"key", "ctrl+3"});
  wait_for_message("Kept this place of the camera as 3. Key 3 goes there.");
  wait_for("a place that is kept", [](const Json& map) { return map["report"]["cameras"]["kept"][2].get<bool>(); });
  press("f");
  ASSERT_NE(next_map()["camera"], before);
  press("3");
  EXPECT_NEAR(next_map()["camera"]["z"].get<double>(), before["z"].get<double>(), 1e-3);
}

TEST_F(CamerasOfAWindow, TurnAboutTheCrowdByADragOfTheMiddleButton) {
  const Json before = next_map()["camera"];
  point_at(400, 300);
  button(2, true);
  point_at(500, 300);
  next_map();
  button(2, false);
  const Json after = next_map()["camera"];
  EXPECT_NE(after["yaw"], before["yaw"]);
  EXPECT_NE(after["x"], before["x"]);
}

TEST_F(CamerasOfAWindow, FollowWhoIsSelected) {
  press("g");
  EXPECT_FALSE(next_map()["report"]["cameras"]["follows"]) << "no agent is selected";
  const Crowd crowd(Scene::grid, 50, 1, load_character(THRONG_SOURCE_DIR "/assets/mannequin.glb", "person")->roles);
  click_at(crowd.positions()[25] + glm::vec3(0.0F, 1.2F, 0.0F));
  wait_for("a selection", [](const Json& map) { return !map["report"]["selected"].is_null(); });
  press("g");
  wait_for("a camera that follows", [](const Json& map) { return map["report"]["cameras"]["follows"].get<bool>(); });
  press("Escape");
  wait_for("a camera that stays", [](const Json& map) { return !map["report"]["cameras"]["follows"].get<bool>(); });
}

}  // namespace
}  // namespace throng::app::camera_test
