// Meshes, morphs and packed palettes, as a renderer of a host's own reads them.

#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/anim/agent/heard_misuses.h"
#include "tests/api/api_crowd.h"
#include "tests/api/smiling.h"

namespace throng::surface_test {
namespace {

using anim::HeardMisuses;
using api_test::ApiCrowd;
using api_test::mannequin;
using api_test::smiling;
using testing::ElementsAre;

TEST(MeshOfACharacter, ShowsItsMaterialAsTheFileHasIt) {
  const Character character = smiling();
  const MeshView mesh = character.mesh(0);
  EXPECT_THAT(mesh.tangents[0], ElementsAre(1.0F, 0.0F, 0.0F, -1.0F));
  EXPECT_THAT(mesh.colors[0], ElementsAre(1.0F, 0.5F, 0.25F, 1.0F));
  EXPECT_EQ(mesh.texture_coords[1][0], 0.6F) << "its base colour has the second coordinates";
  EXPECT_EQ(mesh.base_color_texels[0], 1);
  EXPECT_EQ(mesh.normal_texture.coords[1][0], 0.1F);
  EXPECT_EQ(mesh.normal_texture.texels[0], 5);
  EXPECT_EQ(mesh.normal_scale, 0.5F);
  EXPECT_TRUE(mesh.metallic_roughness_texture.texels.empty() && mesh.occlusion_texture.texels.empty());
  EXPECT_EQ(mesh.metallic, 0.25F);
  EXPECT_EQ(mesh.roughness, 0.75F);
  EXPECT_THAT(mesh.emission, ElementsAre(0.0F, 1.0F, 2.0F));
  EXPECT_EQ(mesh.alpha, AlphaMode::mask);
  EXPECT_EQ(mesh.alpha_cutoff, 0.4F);
  EXPECT_TRUE(mesh.double_sided);
  EXPECT_FALSE(mesh.unlit);
}

TEST(MorphsOfAnAgent, AreToldWithWhatTheyDoToTheSurface) {
  const Character character = smiling();
  EXPECT_THAT(character.morph_names(), ElementsAre("smile"));
  const auto deltas = character.mesh(0).morph_deltas;
  ASSERT_EQ(deltas.size(), 1U);
  EXPECT_EQ(deltas[0].vertex, 2U);
  EXPECT_EQ(deltas[0].morph, 0U);
  EXPECT_EQ(deltas[0].position, (Vec3{0.0F, 0.5F, 0.0F}));
  EXPECT_EQ(deltas[0].normal, (Vec3{0.0F, 1.0F, 0.0F}));

  Crowd crowd = std::move(*Crowd::create(character));
  const Agent agent = crowd.agent(crowd.add_agent());
  float weight = 7.0F;
  EXPECT_FALSE(agent.motion().morph_weights({&weight, 1})) << "it plays nothing";
  EXPECT_EQ(weight, 0.0F);
  agent.play({.clip = {0}});
  crowd.advance(ticks_per_second / 4);
  EXPECT_TRUE(agent.motion().morph_weights({&weight, 1}));
  EXPECT_NEAR(weight, 0.25F, 1e-3F);
  EXPECT_GE(crowd.bounds(agent.id()).high.y - crowd.bounds(agent.id()).low.y, 1.0F) << "it may move up by half a metre";
}

TEST(MorphsOfAnAgent, WithoutRoomForTheirWeightsAreAMisuse) {
  Crowd crowd = std::move(*Crowd::create(smiling()));
  const Agent agent = crowd.agent(crowd.add_agent());
  const HeardMisuses heard;
  EXPECT_FALSE(agent.motion().morph_weights({}));
  EXPECT_THAT(heard.all(), ElementsAre(testing::HasSubstr("Motion::morph_weights")));
}

/// Returns bits `first` to `first + count - 1` of 16 bytes as a signed number.
std::int64_t bits(const std::uint32_t (&words)[4], int first, int count) {
  std::int64_t number = 0;
  for (int bit = count; bit-- > 0;) number = 2 * number + (words[(first + bit) / 32] >> ((first + bit) % 32) & 1U);
  return number - (number >> (count - 1) << count);
}

/// Returns where a packed entry takes a point, as the drawing of PaletteFormat says it.
Vec3 as_drawn(const std::uint32_t (&words)[4], const std::array<float, 4>& frame, const Vec3& point) {
  double q[4], length = 0.0;
  for (int i = 0; i < 4; ++i) q[i] = static_cast<double>(bits(words, 16 * i, 16));
  for (const double number : q) length += number * number;
  const double joint[3] = {static_cast<double>(bits(words, 64, 21)), static_cast<double>(bits(words, 85, 21)),
                           static_cast<double>(bits(words, 106, 22))};
  const double p[3] = {point.x - frame[0], point.y - frame[1], point.z - frame[2]};
  double out[3];
  for (int i = 0; i < 3; ++i) {  // p + 2 q x (q x p + w p), for a quaternion of any length
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const auto inner = [&](int a) {
      const int b = (a + 1) % 3, c = (a + 2) % 3;
      return q[b] * p[c] - q[c] * p[b] + q[3] * p[a];
    };
    out[i] = p[i] + 2.0 * (q[j] * inner(k) - q[k] * inner(j)) / length + static_cast<double>(frame[3]) * joint[i];
  }
  return {static_cast<float>(out[0]), static_cast<float>(out[1]), static_cast<float>(out[2])};
}

TEST(PackedPalette, IsAsItsHeaderDrawsIt) {
  const auto frames = mannequin().packing_frames();
  ApiCrowd matrices(1), packed(1, {.palettes = PaletteFormat::packed});
  for (ApiCrowd* crowd : {&matrices, &packed}) {
    crowd->agent(0).play({.clip = mannequin().find_clip("walk")});
    crowd->step(20);
  }
  constexpr Vec3 point{0.3F, 1.2F, -0.1F};
  for (std::size_t entry = 0; entry < frames.size(); ++entry) {
    std::uint32_t words[4];
    std::memcpy(words, packed.palette({0}) + 4 * entry, sizeof(words));
    const float* const m = matrices.palette({0}) + 12 * entry;
    const Vec3 drawn = as_drawn(words, frames[entry], point);
    EXPECT_NEAR(drawn.x, m[0] * point.x + m[1] * point.y + m[2] * point.z + m[3], 1e-3F) << entry;
    EXPECT_NEAR(drawn.y, m[4] * point.x + m[5] * point.y + m[6] * point.z + m[7], 1e-3F) << entry;
    EXPECT_NEAR(drawn.z, m[8] * point.x + m[9] * point.y + m[10] * point.z + m[11], 1e-3F) << entry;
  }
}

}  // namespace
}  // namespace throng::surface_test
