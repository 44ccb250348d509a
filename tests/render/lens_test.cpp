#include "throng/render/lens.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <gtest/gtest.h>

#include "throng/render/camera.h"

namespace throng::render::lens_test {
namespace {

glm::vec2 seen(const CameraView& view, const glm::vec3& point) {
  const glm::vec4 clip = view.projection * view.view * glm::vec4(point, 1.0F);
  return glm::vec2(clip) / clip.w;
}

TEST(Lens, KeepsWhatIsInFocusAndMovesTheRest) {
  const Camera camera{.position = {3, 2, 1}, .yaw = 0.7F, .pitch = -0.3F};
  const CameraView middle = view_of(camera, 1.5F), beside = seen_through(middle, {0.2F, -0.1F}, 6.0F);
  const glm::vec3 ahead = forward(camera), aside = 1.3F * right(camera);
  const glm::vec3 in_focus = camera.position + 6.0F * ahead + aside;
  EXPECT_LT(glm::distance(seen(middle, in_focus), seen(beside, in_focus)), 1e-5F);
  for (const float away : {2.0F, 60.0F}) {
    const glm::vec3 blurred = camera.position + away * ahead + aside;
    EXPECT_GT(glm::distance(seen(middle, blurred), seen(beside, blurred)), 0.02F) << away;
  }
  EXPECT_NEAR(glm::distance(beside.position, camera.position), glm::length(glm::vec2(0.2F, 0.1F)), 1e-5F);
  const glm::vec4 eye = beside.view * glm::vec4(beside.position, 1.0F);
  EXPECT_LT(glm::length(glm::vec3(eye)), 1e-5F) << "the eye of the matrix is where the position says";
}

TEST(Lens, HasPointsThatLieEvenlyAroundItsMiddle) {
  glm::vec2 sum(0.0F);
  float inner = 0.0F;
  for (int i = 0; i < 32; ++i) {
    const glm::vec2 point = point_of_disc(i, 32);
    EXPECT_LE(glm::length(point), 1.0F);
    if (glm::length(point) < 0.7071F) ++inner;
    sum += point;
  }
  EXPECT_LT(glm::length(sum / 32.0F), 0.06F);
  EXPECT_EQ(inner, 16.0F) << "half of the area has half of the points";
}

TEST(AveragedPicture, IsTheAverageOfLight) {
  Image black = Image::blank(1, 1), white = Image::blank(1, 1);
  for (int channel = 0; channel < 3; ++channel) black.pixel(0, 0)[channel] = 0;
  AveragedPicture average;
  average.add(black);
  average.add(white);
  const Image image = average.finish();
  EXPECT_EQ(image.pixel(0, 0)[0], 188) << "half of the light; half of the number would be 128";
  EXPECT_EQ(image.pixel(0, 0)[3], 255);
}

TEST(AveragedPicture, OfOnePictureIsThatPicture) {
  Image image = Image::blank(16, 16);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) {
    image.rgba[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(i / 4);
  }
  AveragedPicture average;
  average.add(image);
  EXPECT_EQ(average.finish().rgba, image.rgba);
}

}  // namespace
}  // namespace throng::render::lens_test
