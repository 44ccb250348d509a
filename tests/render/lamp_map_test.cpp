#include "engine/render/light/lamp_map.h"

#include <cmath>

#include <gtest/gtest.h>

namespace throng::render::lamp_map_test {
namespace {

constexpr glm::vec3 white(10.0F);

float red_at(const LampLight& light, float x, float z) {
  const auto pixel = [&](float place, float corner) {
    return static_cast<std::size_t>((place - corner) / light.metres * LampLight::side);
  };
  return light.pixels[pixel(z, light.corner.y) * LampLight::side + pixel(x, light.corner.x)].r;
}

TEST(LampLight, IsDarkWithoutLamps) {
  const LampLight light = sum_of_lamps({});
  EXPECT_TRUE(light.pixels.empty());
  EXPECT_EQ(light.metres, 0.0F);
}

TEST(LampLight, FallsWithTheSquareOfTheDistanceBelowALamp) {
  const SceneryLamp low{{0.0F, 3.2F, 0.0F}, white}, high{{0.0F, 5.2F, 0.0F}, white};
  const float near = red_at(sum_of_lamps({&low, 1}), 0.0F, 0.0F), far = red_at(sum_of_lamps({&high, 1}), 0.0F, 0.0F);
  EXPECT_NEAR(near, 10.0F / 4.0F, 0.05F) << "two metres above the breast";
  EXPECT_NEAR(near / far, 4.0F, 0.1F);
}

TEST(LampLight, FadesAllAroundAndEndsInsideTheMap) {
  const SceneryLamp lamp{{7.0F, 4.0F, -3.0F}, white};
  const LampLight light = sum_of_lamps({&lamp, 1});
  EXPECT_GT(red_at(light, 7.0F, -3.0F), red_at(light, 10.0F, -3.0F));
  EXPECT_NEAR(red_at(light, 10.0F, -3.0F), red_at(light, 7.0F, -6.0F), 0.02F);
  EXPECT_LT(light.pixels.front().r, 1e-3F);
  EXPECT_LT(light.pixels.back().r, 1e-3F);
}

TEST(LampLight, AddsUp) {
  const SceneryLamp two[] = {{{0.0F, 4.0F, 0.0F}, white}, {{0.0F, 4.0F, 0.0F}, white}};
  EXPECT_NEAR(red_at(sum_of_lamps(two), 0.0F, 0.0F), 2.0F * red_at(sum_of_lamps({two, 1}), 0.0F, 0.0F), 1e-3F);
}

}  // namespace
}  // namespace throng::render::lamp_map_test
