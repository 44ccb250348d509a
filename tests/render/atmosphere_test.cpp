#include "engine/render/light/atmosphere.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "throng/render/scene_light.h"

namespace throng::render::atmosphere_test {
namespace {

float brightness(const glm::vec3& light) { return light.r + light.g + light.b; }

glm::vec3 sky(float sun_elevation, float elevation, float azimuth) {
  return Atmosphere(direction_at(sun_elevation, 0.0F)).radiance(direction_at(elevation, azimuth));
}
glm::vec3 sunlight(float elevation) { return Atmosphere(direction_at(elevation, 0.0F)).sunlight(); }

TEST(Atmosphere, IsBlueOverheadAndPaleAtTheHorizon) {
  const glm::vec3 overhead = sky(50.0F, 88.0F, 0.0F), low = sky(50.0F, 2.0F, 180.0F);
  EXPECT_GT(overhead.b, 2.0F * overhead.r);
  EXPECT_LT(low.b / low.r, 0.6F * overhead.b / overhead.r);
  EXPECT_GT(brightness(low), brightness(overhead));
}

TEST(Atmosphere, IsBrighterAroundTheSun) {
  EXPECT_GT(brightness(sky(40.0F, 40.0F, 8.0F)), 2.0F * brightness(sky(40.0F, 40.0F, 180.0F)));
}

TEST(Atmosphere, LeavesALowSunItsRed) {
  EXPECT_NEAR(sunlight(90.0F).g, 0.87F, 0.05F) << "a clear sky lets through about this share of green light";
  const glm::vec3 noon = sunlight(60.0F), evening = sunlight(4.0F);
  EXPECT_GT(noon.b / noon.r, 0.75F);
  EXPECT_LT(evening.b / evening.r, 0.25F);
  EXPECT_LT(brightness(evening), 0.6F * brightness(noon));
}

TEST(Atmosphere, GoesOnShiningAfterSunset) {
  EXPECT_EQ(sunlight(-2.0F), glm::vec3(0.0F));
  const float dusk = brightness(sky(-4.0F, 20.0F, 0.0F));
  EXPECT_GT(dusk, 0.0F);
  EXPECT_LT(dusk, 0.1F * brightness(sky(10.0F, 20.0F, 0.0F)));
}

TEST(Atmosphere, ChangesLittleWithTheSunsEveryTenthOfADegree) {
  for (float elevation = -5.0F; elevation < 80.0F; elevation += 0.7F) {
    const float before = brightness(sky(elevation, 30.0F, 60.0F));
    const float after = brightness(sky(elevation + 0.1F, 30.0F, 60.0F));
    EXPECT_NEAR(after / before, 1.0F, 0.12F) << elevation;
  }
}

}  // namespace
}  // namespace throng::render::atmosphere_test
