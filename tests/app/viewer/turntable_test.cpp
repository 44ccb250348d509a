#include "app/viewer/turntable.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace throng::app::turntable_test {
namespace {

constexpr float wide = 16.0F / 9.0F, panel = 0.3F;
const glm::vec3 centre(0.0F, 0.7F, 0.0F);

/// Returns where a point is in the picture: -1 at the left and at the bottom, 1 at the right and at the top.
glm::vec2 in_picture(const render::Camera& camera, const glm::vec3& point) {
  const render::CameraView view = render::view_of(camera, wide);
  const glm::vec4 clip = view.projection * view.view * glm::vec4(point, 1.0F);
  return glm::vec2(clip) / clip.w;
}

InputFrame drag(float x, float y) {
  InputFrame input;
  input.buttons_down.set(static_cast<std::size_t>(MouseButton::left));
  input.moved_x = x;
  input.moved_y = y;
  return input;
}

TEST(Turntable, PutsTheCentreInTheMiddleOfWhatNoPanelCovers) {
  const Turntable table(centre, 1.0F);
  const glm::vec2 whole = in_picture(table.camera(wide, 0.0F), centre);
  EXPECT_NEAR(whole.x, 0.0F, 1e-4F);
  EXPECT_NEAR(whole.y, 0.0F, 1e-4F);
  EXPECT_NEAR(in_picture(table.camera(wide, panel), centre).x, -panel, 1e-4F);
}

TEST(Turntable, FillsTheHeightOfAWidePictureWithTheSphere) {
  const render::Camera camera = Turntable(centre, 1.0F).camera(wide, 0.0F);
  const float seen = std::asin(1.0F / glm::distance(camera.position, centre));
  EXPECT_NEAR(seen, camera.vertical_view / 2, 1e-4F);
}

TEST(Turntable, IsTurnedByADragAndGoesNearerByTheWheel) {
  Turntable table(centre, 1.0F);
  const render::Camera before = table.camera(wide, 0.0F);
  table.update(drag(100, 0), {});
  EXPECT_NE(table.camera(wide, 0.0F).yaw, before.yaw);
  InputFrame wheel;
  wheel.wheel = 3;
  table.update(wheel, {});
  EXPECT_LT(glm::distance(table.camera(wide, 0.0F).position, centre), glm::distance(before.position, centre));
  table.face_front();
  EXPECT_EQ(table.camera(wide, 0.0F), before);
}

TEST(Turntable, LeavesThePointerToThePanel) {
  Turntable table(centre, 1.0F);
  const render::Camera before = table.camera(wide, 0.0F);
  table.update(drag(100, 50), {.pointer_free = false});
  EXPECT_EQ(table.camera(wide, 0.0F), before);
}

TEST(Turntable, StaysAboveTheGround) {
  Turntable table(centre, 1.0F);
  table.update(drag(0, -10'000), {});
  EXPECT_GT(table.camera(wide, 0.0F).position.y, centre.y);
}

}  // namespace
}  // namespace throng::app::turntable_test
