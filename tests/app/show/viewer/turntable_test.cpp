#include "app/show/viewer/turntable.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
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
  const Turntable table(centre, 1.0F, 0.8F);
  const glm::vec2 whole = in_picture(table.camera(wide, 0.0F), centre);
  EXPECT_NEAR(whole.x, 0.0F, 1e-4F);
  EXPECT_NEAR(whole.y, 0.0F, 1e-4F);
  EXPECT_NEAR(in_picture(table.camera(wide, panel), centre).x, -panel, 1e-4F);
}

/// The farthest that the rims of a cylinder are from the middle of the picture, of the way to its edges.
glm::vec2 farthest_of(const render::Camera& camera, float radius, float half_height) {
  glm::vec2 farthest(0.0F);
  for (int point = 0; point < 360; ++point) {
    const float angle = glm::radians(static_cast<float>(point));
    for (const float height : {-half_height, half_height}) {
      const glm::vec3 rim(radius * std::cos(angle), height, radius * std::sin(angle));
      farthest = glm::max(farthest, glm::abs(in_picture(camera, centre + rim)));
    }
  }
  return farthest;
}

TEST(Turntable, FillsThePictureWithTheCylinder) {
  const glm::vec2 tall = farthest_of(Turntable(centre, 0.3F, 1.0F).camera(wide, 0.0F), 0.3F, 1.0F);
  EXPECT_NEAR(tall.y, 1.0F, 0.01F);
  EXPECT_LT(tall.x, 0.5F);
  const glm::vec2 flat = farthest_of(Turntable(centre, 1.0F, 0.1F).camera(wide, 0.0F), 1.0F, 0.1F);
  EXPECT_GT(flat.x, 0.9F) << "who lies down in one of the clips does not make all of them small";
  EXPECT_NEAR(flat.y, 1.0F, 0.01F) << "the near rim";
}

TEST(Turntable, IsTurnedByADragAndGoesNearerByTheWheel) {
  Turntable table(centre, 1.0F, 0.8F);
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
  Turntable table(centre, 1.0F, 0.8F);
  const render::Camera before = table.camera(wide, 0.0F);
  table.update(drag(100, 50), {.pointer_free = false});
  EXPECT_EQ(table.camera(wide, 0.0F), before);
}

TEST(Turntable, StaysAboveTheGround) {
  Turntable table(centre, 1.0F, 0.8F);
  table.update(drag(0, -10'000), {});
  EXPECT_GT(table.camera(wide, 0.0F).position.y, centre.y);
}

}  // namespace
}  // namespace throng::app::turntable_test
