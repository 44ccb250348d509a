#include "engine/anim/import/specular_glossiness.h"

#include <array>
#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::import::testing::specular_glossiness_test {
namespace {

using ::testing::ElementsAre;

/// Diffuse and mirrored light of a metallic-roughness point, as appendix B of glTF 2.0 has them.
glm::vec3 scattered(const MetallicRoughness& point) {
  return glm::vec3(point.base_color) * (1.0F - point.metallic) * 0.96F;
}
glm::vec3 mirrored(const MetallicRoughness& point) {
  return glm::vec3(0.04F) * (1.0F - point.metallic) + glm::vec3(point.base_color) * point.metallic;
}

TEST(SpecularGlossiness, OfADielectricKeepsItsColor) {
  const MetallicRoughness point = to_metallic_roughness(
      {.diffuse = {0.5F, 0.25F, 0.125F, 0.75F}, .specular = glm::vec3(0.04F), .glossiness = 0.25F});
  EXPECT_NEAR(point.metallic, 0.0F, 1e-5F);
  EXPECT_NEAR(point.base_color.r, 0.5F, 1e-5F);
  EXPECT_NEAR(point.base_color.b, 0.125F, 1e-5F);
  EXPECT_EQ(point.base_color.a, 0.75F);
  EXPECT_EQ(point.roughness, 0.75F);
}

TEST(SpecularGlossiness, OfAGreyMixtureSendsBackAsMuchLight) {
  for (const float specular : {0.04F, 0.1F, 0.3F, 0.9F}) {
    const float diffuse = 0.1F;
    const MetallicRoughness point =
        to_metallic_roughness({.diffuse = {diffuse, diffuse, diffuse, 1.0F}, .specular = glm::vec3(specular)});
    EXPECT_NEAR(scattered(point).g + mirrored(point).g, diffuse * (1.0F - specular) + specular, 0.05F) << specular;
  }
}

TEST(SpecularGlossiness, OfImagesOfTwoSizesHasTheLargerOne) {
  const std::array<std::uint8_t, 4> half{0, 0, 0, 128};
  const std::array<std::uint8_t, 16> four{255, 255, 255, 255, 0, 0, 0, 64, 255, 0, 0, 255, 0, 0, 255, 255};
  const anim::Image small{.width = 1, .height = 1, .rgba = half}, large{.width = 2, .height = 2, .rgba = four};
  const MetallicRoughnessImages images = to_metallic_roughness(large, small, {.glossiness = 0.5F});
  EXPECT_EQ(images.base_color.width, 2);
  EXPECT_EQ(images.base_color.height, 2);
  EXPECT_EQ(images.base_color.rgba[7], 64) << "alpha is that of the diffuse colour";
  EXPECT_EQ(images.metallic_roughness.rgba[13], 191) << "1 - 0.5 * 128 / 255";
  EXPECT_EQ(images.metallic_roughness.rgba[14], 0) << "black mirrors nothing";
}

}  // namespace
}  // namespace throng::import::testing::specular_glossiness_test
