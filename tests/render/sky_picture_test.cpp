#include "engine/render/light/sky_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/render/even_directions.h"

namespace throng::render::sky_picture_test {
namespace {

float brightness(const glm::vec3& light) { return (light.r + light.g + light.b) / 3.0F; }

/// Computes what the polynomial of shaders/lighting.glsl gives.
glm::vec3 ambient_light(const LightUniforms& light, const glm::vec3& n) {
  const float terms[] = {
      1.0F, n.y, n.z, n.x, n.x * n.y, n.y * n.z, 3.0F * n.y * n.y - 1.0F, n.x * n.z, n.z * n.z - n.x * n.x};
  glm::vec3 sum(0.0F);
  for (int i = 0; i < sky_harmonics; ++i) sum += glm::vec3(light.harmonics[i]) * terms[i];
  return sum;
}

/// Sums up what a white surface receives, direction by direction.
glm::vec3 received(const SkyPicture& sky, const glm::vec3& normal) {
  constexpr int count = 20'000;
  glm::vec3 sum(0.0F);
  for (int i = 0; i < count; ++i) {
    const glm::vec3 direction = even_direction(i, count);
    sum += sky.radiance_in_town(direction) * std::max(glm::dot(direction, normal), 0.0F);
  }
  return sum * (4.0F / count);
}

TEST(SkyPlace, UnfoldsTheUpperHalfAndFoldsItBack) {
  for (const glm::vec3& direction :
       {glm::vec3(0, 1, 0), glm::vec3(1, 0, 0), glm::vec3(0.3F, 0.5F, -0.7F), glm::vec3(-0.9F, 0.1F, 0.4F)}) {
    const glm::vec2 place = sky_place(glm::normalize(direction));
    EXPECT_TRUE(place.x >= 0.0F && place.x <= 1.0F && place.y >= 0.0F && place.y <= 1.0F);
    EXPECT_LT(glm::distance(sky_direction(place), glm::normalize(direction)), 1e-5F);
  }
}

TEST(SkyPicture, GivesSurfacesTheLightThatItShows) {
  for (const SceneLight& light : {SceneLight{}, SceneLight{.sun_elevation = 8.0F}, SceneLight{.clouds = 1.0F}}) {
    const SkyPicture sky(light);
    for (const glm::vec3& normal : {glm::vec3(0, 1, 0), glm::vec3(0, -1, 0), glm::vec3(1, 0, 0), glm::vec3(0, 0, -1),
                                    glm::normalize(glm::vec3(1, 1, 1))}) {
      const float exact = brightness(received(sky, normal));
      EXPECT_NEAR(brightness(ambient_light(sky.uniforms(), normal)), exact, 0.06F * exact);
    }
  }
}

TEST(SkyPicture, CoversTheSkyAsFarAsAsked) {
  const auto covered = [](float clouds) {
    const SkyPicture sky({.clouds = clouds});
    const auto hidden = std::ranges::count_if(sky.map(), [](const glm::vec4& pixel) { return pixel.a < 0.5F; });
    return static_cast<float>(hidden) / static_cast<float>(sky.map().size());
  };
  EXPECT_EQ(covered(0.0F), 0.0F);
  EXPECT_LT(covered(0.2F), covered(0.5F));
  EXPECT_NEAR(covered(0.5F), 0.35F, 0.2F);
  EXPECT_EQ(covered(1.0F), 1.0F);
}

TEST(SkyPicture, HidesTheSunBehindClosedClouds) {
  const LightUniforms clear = SkyPicture({.clouds = 0.0F}).uniforms(), closed = SkyPicture({.clouds = 1.0F}).uniforms();
  EXPECT_LT(brightness(closed.sun_light), 0.1F * brightness(clear.sun_light));
  EXPECT_GT(brightness(closed.harmonics[0]), brightness(clear.harmonics[0]));
}

TEST(SkyPicture, TakesAStopAsTwiceTheLight) {
  const LightUniforms usual = SkyPicture({}).uniforms(), more = SkyPicture({.exposure = 1.0F}).uniforms();
  EXPECT_NEAR(brightness(more.sun_light), 2.0F * brightness(usual.sun_light), 1e-3F);
  EXPECT_NEAR(brightness(more.haze), 2.0F * brightness(usual.haze), 1e-2F);
}

TEST(SkyPicture, ThinsHazeThatIsBrightSoThatACrowdKeepsItsColours) {
  const glm::vec4 noon = SkyPicture({}).uniforms().clearing,
                  evening = SkyPicture({.sun_elevation = 9.0F}).uniforms().clearing;
  EXPECT_LT(evening.g, 0.6F * noon.g);
  EXPECT_NEAR(evening.b / evening.r, noon.b / noon.r, 1e-3F);
}

TEST(SkyPicture, LightsPeopleFromSunlitWallsWhileTheSunIsLow) {
  const SceneLight low{.sun_elevation = 9.0F, .sun_azimuth = 90.0F, .clouds = 0.0F};  // from +x
  const SkyPicture evening(low), noon(SceneLight{});
  const glm::vec3 lit(-0.99F, 0.1F, 0.0F), shaded(0.99F, 0.1F, 0.0F);
  EXPECT_GT(brightness(evening.radiance_in_town(lit)), 2.0F * brightness(evening.radiance_in_town(shaded)));
  EXPECT_GT(evening.radiance_in_town(lit).r, 1.5F * evening.radiance_in_town(lit).b) << "warm";
  EXPECT_EQ(evening.radiance_in_town({0.0F, 1.0F, 0.0F}), evening.radiance({0.0F, 1.0F, 0.0F})) << "no roof overhead";
  EXPECT_EQ(noon.radiance_in_town(lit), noon.radiance(lit));
}

TEST(SkyPicture, LightsWindowsAtNightAlone) {
  EXPECT_EQ(SkyPicture({}).uniforms().night, 0.0F);
  const LightUniforms night = SkyPicture({.sun_elevation = -12.0F}).uniforms();
  EXPECT_EQ(night.night, 1.0F);
  EXPECT_GT(night.to_sun.y, 0.3F) << "the moon stands above the horizon";
  EXPECT_GT(night.sun_light.b, night.sun_light.r);
  EXPECT_LT(brightness(night.sun_light), 0.4F * brightness(SkyPicture({}).uniforms().sun_light));
}

TEST(SkyPicture, BlursWhatRoughSurfacesMirror) {
  const SkyPicture sky(SceneLight{.sun_elevation = 12.0F, .clouds = 0.0F});
  const auto contrast = [&](int level) {
    float least = 1e9F, most = 0.0F;
    for (int face = 0; face < 6; ++face) {
      for (const glm::vec4& pixel : sky.environment(face, level)) {
        least = std::min(least, brightness(glm::vec3(pixel)));
        most = std::max(most, brightness(glm::vec3(pixel)));
      }
    }
    return most / least;
  };
  EXPECT_GT(contrast(0), contrast(2));
  EXPECT_GT(contrast(2), contrast(5));
  EXPECT_GT(contrast(5), 1.0F);
}

TEST(SkyPicture, MirrorsEachDirectionFromWhereItIs) {
  const SkyPicture sky(SceneLight{});
  // The middle of the faces +x, -x, +y, -y, +z and -z.
  const glm::vec3 directions[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (int face = 2; face < 4; ++face) {
    const std::vector<glm::vec4> pixels = sky.environment(face, 0);
    const std::size_t side = SkyPicture::environment_side;
    const glm::vec3 middle(pixels[side / 2 * side + side / 2]);
    EXPECT_LT(glm::distance(middle, sky.radiance(directions[face])), 0.05F) << face;
  }
}

}  // namespace
}  // namespace throng::render::sky_picture_test
