#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/gl/gl_test.h"
#include "tests/gl/picture_tolerance.h"
#include "tests/gl/sheet.h"

namespace throng::render::test::surface_light_test {
namespace {

constexpr int nearest = 9728;

/// Draws sheets whose material light reads as glTF 2.0, appendix B, says.
class SurfaceLight : public SheetTest {
 protected:
  void paint(float red, float green, float blue) {
    const std::array<float, 3> color{red, green, blue};
    std::copy(color.begin(), color.end(), material().base_color);
  }

  /// Shows the texels of an image of `width` columns, without a blend between them.
  TextureData show(std::span<const std::uint8_t> rgba, int width) {
    sheet().images.push_back({width, static_cast<int>(rgba.size()) / 4 / width, rgba});
    const int image = static_cast<int>(sheet().images.size()) - 1;
    return {.image = image, .magnified = nearest, .minified = nearest};
  }

  double middle(int channel = 1) { return Sheet::brightness(sheet().picture(), 0.5F, 0.5F, channel); }
};

// The upper half faces up, the lower half down.
constexpr std::array<std::uint8_t, 8> bump = {128, 218, 218, 255, 128, 38, 218, 255};
constexpr std::array<std::uint8_t, 8> hollow = {128, 38, 218, 255, 128, 218, 218, 255};

TEST_F(SurfaceLight, FallsOnTheTopOfABumpFromAbove) {
  const std::vector<float> upright = {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1};
  sheet().tangents = upright;
  material().normal_texture = show(bump, 1);
  const Image bumped = sheet().picture();
  EXPECT_GT(Sheet::brightness(bumped, 0.5F, 0.4F), Sheet::brightness(bumped, 0.5F, 0.6F) + 40.0);
  sheet().images[0].rgba = hollow;
  const Image hollowed = sheet().picture();
  EXPECT_LT(Sheet::brightness(hollowed, 0.5F, 0.4F), Sheet::brightness(hollowed, 0.5F, 0.6F) - 40.0);
}

TEST_F(SurfaceLight, FallsOnTheTopOfABumpThatIsUpsideDown) {
  sheet().tangents = {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1};
  material().normal_texture = show(bump, 1);
  sheet().turn_upside_down();
  const Image picture = sheet().picture();
  EXPECT_GT(Sheet::brightness(picture, 0.5F, 0.4F), Sheet::brightness(picture, 0.5F, 0.6F) + 40.0)
      << "its tangents turn with it";
}

TEST_F(SurfaceLight, KnowsTheSideOfTheBitangentAndTheScaleOfBumps) {
  material().normal_texture = show(bump, 1);
  sheet().tangents = {1, 0, 0, -1, 1, 0, 0, -1, 1, 0, 0, -1, 1, 0, 0, -1};
  const Image mirrored = sheet().picture();
  EXPECT_LT(Sheet::brightness(mirrored, 0.5F, 0.4F), Sheet::brightness(mirrored, 0.5F, 0.6F) - 40.0);
  material().normal_scale = 0.1F;
  const Image low = sheet().picture();
  EXPECT_NEAR(Sheet::brightness(low, 0.5F, 0.4F), Sheet::brightness(low, 0.5F, 0.6F), 25.0);
  sheet().tangents = {};
  const Image without = sheet().picture();
  EXPECT_NEAR(Sheet::brightness(without, 0.5F, 0.4F), Sheet::brightness(without, 0.5F, 0.6F), 2.0);
}

TEST_F(SurfaceLight, IsMirroredByMetalInItsColorAlone) {
  paint(0.9F, 0.0F, 0.0F);
  material().roughness = 0.5F;
  const double of_paint = middle(2), red_of_paint = middle(0);
  material().metallic = 1.0F;
  EXPECT_GT(middle(0), 60.0);
  EXPECT_LT(middle(2), 0.5 * of_paint) << "paint mirrors white light";
  EXPECT_GT(of_paint, 10.0);
  EXPECT_GT(std::abs(red_of_paint - middle(0)), 10.0);
  paint(0.0F, 0.0F, 0.0F);
  EXPECT_LT(middle(0), 12.0) << "metal scatters nothing";
}

TEST_F(SurfaceLight, IsWidestOnTheRoughest) {
  // The sun is mirrored into the camera by the middle of the sheet.
  sheet().face(glm::normalize(glm::vec3(0.0F, std::sqrt(0.5F), std::sqrt(0.5F)) + glm::vec3(0.0F, 0.0F, 1.0F)));
  paint(0.0F, 0.0F, 0.0F);
  const auto fall = [&](float roughness) {
    material().roughness = roughness;
    const Image image = sheet().picture();
    return Sheet::brightness(image, 0.5F, 0.5F) - Sheet::brightness(image, 0.8F, 0.5F);
  };
  const double smooth = fall(0.2F), rough = fall(0.5F), matt = fall(0.79F);
  EXPECT_GT(smooth, 60.0);
  EXPECT_GT(smooth, rough + 20.0);
  EXPECT_GT(rough, matt);
  material().roughness = 0.1F;
  EXPECT_GT(middle(), 250.0) << "and brightest on the smoothest";
}

TEST_F(SurfaceLight, IsSpreadByBumpsThatAreTooSmallToBeSeen) {
  constexpr std::array<std::uint8_t, 16> bumps = {188, 128, 240, 255, 128, 188, 240, 255,
                                                  128, 68,  240, 255, 68,  128, 240, 255};
  constexpr std::array<std::uint8_t, 16> flat = {128, 128, 255, 255, 128, 128, 255, 255,
                                                 128, 128, 255, 255, 128, 128, 255, 255};
  sheet().face(glm::normalize(glm::vec3(0.0F, std::sqrt(0.5F), std::sqrt(0.5F)) + glm::vec3(0.0F, 0.0F, 1.0F)));
  sheet().tangents = {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1};
  for (float& coord : sheet().coords) coord *= 500.0F;
  paint(0.0F, 0.0F, 0.0F);
  material().roughness = 0.2F;
  material().normal_texture = show(bumps, 2);
  material().normal_texture.minified = 9987;  // between mip levels, of which the last is flat
  const Image rough = sheet().picture();
  sheet().images[0].rgba = flat;
  const Image smooth = sheet().picture();
  EXPECT_GT(Sheet::brightness(smooth, 0.5F, 0.5F), Sheet::brightness(rough, 0.5F, 0.5F) + 15.0);
  EXPECT_LT(Sheet::brightness(smooth, 0.7F, 0.5F), Sheet::brightness(rough, 0.7F, 0.5F));
}

TEST_F(SurfaceLight, OfTheSkyAloneIsKeptAwayByOcclusion) {
  constexpr std::array<std::uint8_t, 4> dark = {0, 255, 255, 255};
  material().roughness = 0.5F;
  const double open_in_sun = middle();
  material().occlusion_texture = show(dark, 1);
  const double in_sun = middle();
  EXPECT_LT(in_sun, open_in_sun - 5.0);
  EXPECT_GT(in_sun, 100.0) << "the sun reaches it";
  sheet().light.sun_azimuth = 180.0F;  // behind the sheet
  EXPECT_LT(middle(), 8.0);
  material().occlusion_strength = 0.5F;
  const double half = middle();
  material().occlusion_strength = 0.0F;
  const double open = middle();
  EXPECT_GT(open, half + 10.0);
  EXPECT_GT(half, 20.0);
}

TEST_F(SurfaceLight, ReadsNumbersOfAnImageAsTheyAreAndItsColorsAsSrgb) {
  constexpr std::array<std::uint8_t, 4> half = {128, 128, 128, 255};
  const TextureData both = show(half, 1);
  material().metallic = 1.0F;
  material().roughness = 1.0F;
  material().metallic_roughness_texture = material().base_color_texture = both;
  const Image by_texture = sheet().picture();
  material().metallic_roughness_texture = material().base_color_texture = {};
  material().metallic = material().roughness = 128.0F / 255.0F;
  paint(0.2159F, 0.2159F, 0.2159F);
  EXPECT_LT(measure_difference(by_texture, sheet().picture())->mean, 0.6);
  material().roughness = 0.2159F;
  EXPECT_GT(measure_difference(by_texture, sheet().picture())->mean, 2.0) << "as if decoded from sRGB";
}

TEST_F(SurfaceLight, TurnsNoOrangeIntoYellow) {
  paint(0.72F, 0.24F, 0.02F);  // 220, 134, 39 in sRGB
  sheet().face(glm::normalize(glm::vec3(0.0F, 1.0F, 1.0F)));
  const Image image = sheet().picture();
  const double red = Sheet::brightness(image, 0.5F, 0.5F, 0), green = Sheet::brightness(image, 0.5F, 0.5F, 1);
  EXPECT_GT(red, 200.0);
  EXPECT_LT(green / red, 0.72) << "134 of 220 is 0.61; a curve for each channel alone makes it 0.8";
}

TEST_F(SurfaceLight, FallsOnTheBackOfWhatHasTwoSides) {
  for (const float roughness : {0.5F, 1.0F}) {
    material() = {};
    material().roughness = roughness;
    material().double_sided = true;
    const double front = middle();
    sheet().turn_around();
    sheet().face({0, 0, -1});
    EXPECT_NEAR(middle(), front, 1.0) << roughness;
    sheet().face({0, 0, 1});
    EXPECT_LT(middle(), front - 20.0) << roughness;
    sheet().turn_back();
  }
}

TEST_F(SurfaceLight, TakesTheColorsOfVertices) {
  material().roughness = 0.5F;
  paint(1.0F, 0.5F, 0.5F);
  sheet().colors = {0.5F, 1, 0, 1, 0.5F, 1, 0, 1, 0.5F, 1, 0, 1, 0.5F, 1, 0, 1};
  const Image multiplied = sheet().picture();
  sheet().colors = {};
  paint(0.5F, 0.5F, 0.0F);
  EXPECT_LT(measure_difference(multiplied, sheet().picture())->mean, 0.6);
}

TEST_F(SurfaceLight, ReadsEachTextureAtCoordinatesOfItsOwn) {
  constexpr std::array<std::uint8_t, 8> two = {0, 40, 0, 255, 255, 255, 255, 255};
  material().metallic = 1.0F;
  sheet().tangents = {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1};
  sheet().read_at(0.25F, 0.5F);
  const TextureData texture = show(two, 2);
  const auto differs = [&](TextureData MaterialData::*property, std::vector<float> Sheet::*coords) {
    material() = {};
    material().metallic = 0.5F;
    material().*property = texture;
    const double shared = middle();
    sheet().*coords = Sheet::all_at(0.75F, 0.5F);
    const double own = middle();
    sheet().*coords = {};
    return std::abs(own - shared);
  };
  EXPECT_GT(differs(&MaterialData::metallic_roughness_texture, &Sheet::metallic_roughness_coords), 5.0);
  EXPECT_GT(differs(&MaterialData::normal_texture, &Sheet::normal_coords), 5.0);
  EXPECT_GT(differs(&MaterialData::occlusion_texture, &Sheet::occlusion_coords), 5.0);
}

}  // namespace
}  // namespace throng::render::test::surface_light_test
