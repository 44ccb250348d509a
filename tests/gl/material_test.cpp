#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/gl/doll_crowd.h"
#include "tests/gl/gl_test.h"
#include "tests/gl/picture_tolerance.h"

namespace throng::render::test::material_test {
namespace {

constexpr std::size_t crowd_size = 15;
constexpr std::array<std::uint8_t, 8> red_and_blue = {255, 0, 0, 255, 0, 0, 255, 255};
constexpr int nearest = 9728, clamp = 33071, mirror = 33648, repeat = 10497;

/// Draws dolls of one material before the ground. The middle of the picture is a chest.
class Material : public SoftwareGlTest {
 protected:
  void SetUp() override {
    SoftwareGlTest::SetUp();
    use_samples(0);
  }
  void TearDown() override {
    crowd_.reset();
    SoftwareGlTest::TearDown();
  }

  void use_samples(int samples) {
    crowd_ = std::make_unique<DollCrowd>(context(), samples);
    crowd_->stand(crowd_size);
    crowd_->write_palettes();
    for (InstanceRecord& record : crowd_->instances) record.contact_scale = 0.0F;  // no spots below the feet
  }

  Image picture(const MaterialData& material) {
    CrowdMeshData doll = crowd_->doll().mesh_data();
    doll.parts[0].regions = {};  // no tints
    doll.parts[0].texture_coords = coords_;
    doll.parts[0].emission_coords = emission_coords_;
    doll.images = {{2, 1, red_and_blue}};
    doll.materials = {material};
    const std::vector<CrowdMeshData> dolls(2, doll);
    EXPECT_TRUE(crowd_->renderer().load_characters(dolls));
    return crowd_->picture();
  }

  Image ground() {
    crowd_->renderer().draw({crowd_->frame().camera, {}, {}, 0, false});
    return crowd_->renderer().read_image();
  }

  DollCrowd& crowd() { return *crowd_; }

  /// Lets every vertex read the texture at `u`.
  void read_texture_at(float u) { coords_ = coords_at(u); }

  /// Lets every vertex read the emission's texture at a place of its own.
  void read_emission_at(float u) { emission_coords_ = coords_at(u); }

 private:
  std::vector<float> coords_at(float u) const {
    std::vector<float> coords;
    for (std::size_t i = 0; i < crowd_->doll().vertex_count(); ++i) coords.insert(coords.end(), {u, 0.5F});
    return coords;
  }

  std::unique_ptr<DollCrowd> crowd_;
  std::vector<float> coords_;
  std::vector<float> emission_coords_;
};

/// The colour of the picture's middle.
std::array<int, 3> middle(const Image& image) {
  const std::uint8_t* pixel = image.pixel(image.width / 2, image.height / 2);
  return {pixel[0], pixel[1], pixel[2]};
}

MaterialData blended(float alpha) {
  MaterialData material;
  material.base_color[3] = alpha;
  material.blended = true;
  return material;
}

TEST_F(Material, WithoutAnyAlphaIsNotSeenAndCastsNoShadow) {
  for (const int samples : {0, 4}) {
    use_samples(samples);
    EXPECT_EQ(measure_difference(ground(), picture(blended(0.0F)))->mean, 0.0) << samples;
    MaterialData cut_out;
    cut_out.base_color[3] = 0.25F;
    cut_out.alpha_cutoff = 0.5F;
    EXPECT_EQ(measure_difference(ground(), picture(cut_out))->mean, 0.0) << samples;
  }
}

TEST_F(Material, OfWhichAllAlphaIsOneIsDrawnAsOpaque) {
  const Image opaque = picture({});
  const DrawCounts counts = crowd().renderer().draw(crowd().frame());
  EXPECT_EQ(measure_difference(opaque, picture(blended(1.0F)))->mean, 0.0);
  EXPECT_EQ(crowd().renderer().draw(crowd().frame()).draw_calls, counts.draw_calls);
}

TEST_F(Material, IsSeenThroughAsFarAsItsAlphaSays) {
  for (const int samples : {0, 4}) {
    use_samples(samples);
    crowd().instances.resize(3);  // the third stands in the middle, nobody behind it
    MaterialData glass = blended(0.5F);
    glass.unlit = true;
    const auto front = middle(picture(glass)), behind = middle(ground());
    for (std::size_t i = 0; i < 3; ++i) {
      // In linear light the mean of white and the ground.
      const double ground_light = std::pow(behind.at(i) / 255.0, 2.2), seen = std::pow(front.at(i) / 255.0, 2.2);
      EXPECT_NEAR(seen, 0.5 + 0.5 * ground_light, 0.06) << samples;
    }
  }
}

TEST_F(Material, LooksTheSameInAnyOrderOfWhoIsSeenThrough) {
  const Image before = picture(blended(0.4F));
  std::reverse(crowd().instances.begin(), crowd().instances.end());
  EXPECT_TRUE(looks_the_same(*measure_difference(before, crowd().picture())));
}

TEST_F(Material, ThatIsUnlitShowsItsOwnColor) {
  MaterialData material;
  material.unlit = true;
  for (int i = 0; i < 3; ++i) material.base_color[i] = 0.2159F;  // 128 in sRGB
  for (const int channel : middle(picture(material))) EXPECT_NEAR(channel, 128, 2);
  material.base_color[0] = 0.8F;   // 231 in sRGB
  material.base_color[2] = 0.01F;  // 25
  const auto color = middle(picture(material));
  EXPECT_NEAR(color[0], 231, 2);
  EXPECT_NEAR(color[1], 128, 3);
  EXPECT_NEAR(color[2], 25, 6) << "but for the haze";
}

TEST_F(Material, WithoutATintIsAsBrightAsTheShadeOfItsAgentSays) {
  MaterialData material;
  material.unlit = true;
  for (int i = 0; i < 3; ++i) material.base_color[i] = 0.2159F;
  for (AgentLook& look : crowd().looks) look.shade = 0x810000U | 0x7FU;  // red 1.35, blue 0.65 times
  const auto color = middle(picture(material));
  EXPECT_NEAR(color[0], 147, 2);
  EXPECT_NEAR(color[1], 128, 2);
  EXPECT_NEAR(color[2], 105, 2);
}

TEST_F(Material, ThatShinesShowsItsEmissionOnBlack) {
  MaterialData material;
  for (int i = 0; i < 3; ++i) material.base_color[i] = 0.0F;
  material.emission[0] = 1.0F;
  material.emission_texture = {.image = 0, .minified = nearest};
  read_texture_at(0.25F);
  const auto red = middle(picture(material));
  EXPECT_GT(red[0], 230);
  EXPECT_LT(red[2], 90) << "no more than the light of the sky on black";
  read_texture_at(0.75F);
  EXPECT_LT(middle(picture(material))[0], 90) << "the texture is blue there";
  read_emission_at(0.25F);
  EXPECT_EQ(middle(picture(material)), red) << "which the emission need not share with the base colour";
}

TEST_F(Material, WrapsItsTextureAsItsSamplerSays) {
  const auto is_red = [&](float u, int wrap) {
    MaterialData material;
    material.unlit = true;
    material.base_color_texture = {
        .image = 0, .wrap_u = wrap, .wrap_v = wrap, .magnified = nearest, .minified = nearest};
    read_texture_at(u);
    const auto color = middle(picture(material));
    EXPECT_GT(std::abs(color[0] - color[2]), 150);
    return color[0] > color[2];
  };
  EXPECT_TRUE(is_red(1.25F, repeat));
  EXPECT_FALSE(is_red(1.75F, repeat));
  EXPECT_FALSE(is_red(1.25F, mirror));
  EXPECT_TRUE(is_red(1.75F, mirror));
  EXPECT_FALSE(is_red(1.25F, clamp));
  EXPECT_TRUE(is_red(-0.25F, clamp));
}

}  // namespace
}  // namespace throng::render::test::material_test
