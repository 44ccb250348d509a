#include <cstddef>
#include <memory>

#include <gtest/gtest.h>

#include "tests/gl/doll_crowd.h"
#include "tests/gl/gl_test.h"

namespace throng::render::test::haze_test {
namespace {

class Haze : public SoftwareGlTest {};

/// How far the ground differs from one row of the picture to the next: haze leaves it plain.
int paving_below_the_horizon(const Image& image) {
  const int row = image.height * 9 / 16;
  int difference = 0;
  for (int column = 0; column + 1 < image.width; ++column) {
    difference += std::abs(image.pixel(column, row)[0] - image.pixel(column + 1, row)[0]);
  }
  return difference;
}

TEST_F(Haze, IsThinnerWhereTheDistancesOfTheSceneAreLarger) {
  DollCrowd crowd(context());
  CrowdFrame frame = crowd.frame();
  frame.instances = {};
  frame.batches = {};
  frame.camera.position.y = 60.0F;
  crowd.renderer().draw(frame);
  const int among_people = paving_below_the_horizon(crowd.renderer().read_image());
  frame.distance_scale = 12.0F;
  crowd.renderer().draw(frame);
  EXPECT_GT(paving_below_the_horizon(crowd.renderer().read_image()), among_people);
}

}  // namespace
}  // namespace throng::render::test::haze_test
