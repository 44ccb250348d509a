// Surfaces of a host's own characters.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/api/api_crowd.h"
#include "tests/api/small_builder.h"

namespace throng::character_builder_meshes_test {
namespace {

using api_test::built;
using api_test::fault_of;
using api_test::small;
using testing::HasSubstr;

/// A triangle beside the tip, which moves it. It has all that a vertex may have, and a texel.
struct Triangle {
  Vec3 positions[3] = {{1.0F, 1.0F, 0.0F}, {2.0F, 1.0F, 0.0F}, {1.0F, 2.0F, 0.0F}};
  Vec3 normals[3] = {{0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, 1.0F}};
  std::array<float, 4> tangents[3] = {{1.0F, 0.0F, 0.0F, -1.0F}, {1.0F, 0.0F, 0.0F, -1.0F}, {1.0F, 0.0F, 0.0F, -1.0F}};
  std::array<float, 4> colors[3] = {{0.1F, 0.2F, 0.3F, 1.0F}, {}, {}};
  std::array<std::uint16_t, 4> bones[3] = {{1}, {1}, {1}};
  std::array<float, 4> weights[3] = {{1.0F}, {1.0F}, {1.0F}};
  std::uint32_t indices[3] = {0, 1, 2};
  std::uint8_t texels[5][4] = {{1}, {2}, {3}, {4}, {5}};
  std::array<float, 2> coords[3] = {{0.0F, 0.0F}, {1.0F, 0.0F}, {0.0F, 1.0F}};

  MeshView view() const {
    MeshView mesh;
    mesh.name = "flag";
    mesh.positions = positions;
    mesh.normals = normals;
    mesh.palette_entries = bones;
    mesh.weights = weights;
    mesh.indices = indices;
    return mesh;
  }
  TextureView texture(int number) const {
    return {.texels = texels[number], .width = 1, .height = 1, .coords = coords};
  }
};

/// Where a vertex is drawn, and its normal.
struct Drawn {
  Vec3 place, normal;
};

/// Returns how the last vertex of a character's first mesh is drawn while clip 0 plays.
Drawn drawn(const Character& character) {
  Crowd crowd = std::move(*Crowd::create(character));
  alignas(64) std::array<float, 64> palette{};
  const PoseRequest request{.agent = crowd.add_agent(), .palette = reinterpret_cast<std::byte*>(palette.data())};
  crowd.agent(request.agent).play({.clip = {0}});
  crowd.update({&request, 1});
  const MeshView mesh = character.mesh(0);
  const float* const rows = &palette[std::size_t{12} * mesh.palette_entries[2][0]];
  const auto moved = [rows](const Vec3& v, float one) {
    const auto row = [&](int r) { return rows[4 * r] * v.x + rows[4 * r + 1] * v.y + rows[4 * r + 2] * v.z; };
    return Vec3{row(0) + one * rows[3], row(1) + one * rows[7], row(2) + one * rows[11]};
  };
  return {.place = moved(mesh.positions[2], 1.0F), .normal = moved(mesh.normals[2], 0.0F)};
}

void expect_near(const Vec3& a, const Vec3& b) {
  EXPECT_NEAR(a.x, b.x, 1e-5F);
  EXPECT_NEAR(a.y, b.y, 1e-5F);
  EXPECT_NEAR(a.z, b.z, 1e-5F);
}

TEST(CharacterBuilder, DrawsAMeshWhereItWasBound) {
  CharacterBuilder builder = small();
  builder.add_mesh(Triangle().view());
  const Character character = built(builder, {.keep_meshes = true});
  ASSERT_EQ(character.mesh_count(), 1U);
  expect_near(drawn(character).place, {1.0F, 2.0F, 0.0F});
  expect_near(drawn(character).normal, {0.0F, 0.0F, 1.0F});
}

TEST(CharacterBuilder, BringsAMeshFromItsBindPoseToItsRestPose) {
  // A quarter about x takes +Y of the bind pose to +Z. The tip was bound 2 m from the root.
  constexpr float lying[] = {1.0F, 0.0F,  0.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F,
                             0.0F, -1.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 1.0F};
  constexpr float above[] = {1.0F, 0.0F,  0.0F, 0.0F, 0.0F, 0.0F, 1.0F,  0.0F,
                             0.0F, -1.0F, 0.0F, 0.0F, 0.0F, 0.0F, -2.0F, 1.0F};
  CharacterBuilder builder("bound");
  builder.add_bone({.name = "root", .inverse_bind = to_mat4(lying)});
  builder.add_bone(
      {.name = "tip", .parent = 0, .rest = {.translation = {0.0F, 1.0F, 0.0F}}, .inverse_bind = to_mat4(above)});
  builder.add_mesh(Triangle().view());
  const Character character = built(builder, {.keep_meshes = true});
  ASSERT_EQ(character.mesh_count(), 1U);
  expect_near(drawn(character).place, {1.0F, 1.0F, 0.0F});
  expect_near(drawn(character).normal, {0.0F, -1.0F, 0.0F});
}

TEST(CharacterBuilder, KeepsTheMaterialOfAMesh) {
  const Triangle triangle;
  MeshView mesh = triangle.view();
  mesh.base_color = {0.1F, 0.2F, 0.3F, 0.4F};
  mesh.alpha = AlphaMode::mask;
  mesh.alpha_cutoff = 0.25F;
  mesh.double_sided = mesh.unlit = true;
  mesh.metallic = 0.2F;
  mesh.roughness = 0.5F;
  mesh.normal_scale = 0.3F;
  mesh.occlusion_strength = 0.6F;
  mesh.emission = {1.0F, 2.0F, 3.0F};
  CharacterBuilder builder = small();
  builder.add_mesh(mesh);
  const Character character = built(builder, {.keep_meshes = true});
  const MeshView kept = character.mesh(0);
  EXPECT_EQ(kept.base_color, mesh.base_color);
  EXPECT_EQ(kept.alpha, AlphaMode::mask);
  EXPECT_EQ(kept.alpha_cutoff, 0.25F);
  EXPECT_TRUE(kept.double_sided && kept.unlit);
  EXPECT_EQ(kept.metallic, 0.2F);
  EXPECT_EQ(kept.roughness, 0.5F);
  EXPECT_EQ(kept.normal_scale, 0.3F);
  EXPECT_EQ(kept.occlusion_strength, 0.6F);
  EXPECT_EQ(kept.emission, mesh.emission);
  EXPECT_TRUE(kept.base_color_texels.empty());
}

TEST(CharacterBuilder, KeepsAMaterialOfItsOwnForEachMesh) {
  const Triangle triangle;
  MeshView solid = triangle.view(), glass = triangle.view();
  glass.alpha = AlphaMode::blend;
  CharacterBuilder builder = small();
  builder.add_mesh(solid);
  builder.add_mesh(glass);
  const Character character = built(builder, {.keep_meshes = true});
  EXPECT_EQ(character.mesh(0).alpha, AlphaMode::opaque);
  EXPECT_EQ(character.mesh(1).alpha, AlphaMode::blend);
}

TEST(CharacterBuilder, KeepsEachTextureApart) {
  const Triangle triangle;
  MeshView mesh = triangle.view();
  mesh.base_color_texels = triangle.texels[0];
  mesh.texture_width = mesh.texture_height = 1;
  mesh.texture_coords = triangle.coords;
  mesh.metallic_roughness_texture = triangle.texture(1);
  mesh.normal_texture = triangle.texture(2);
  mesh.occlusion_texture = triangle.texture(3);
  mesh.emission_texture = triangle.texture(4);
  CharacterBuilder builder = small();
  builder.add_mesh(mesh);
  const Character character = built(builder, {.keep_meshes = true});
  const MeshView kept = character.mesh(0);
  const std::span<const std::uint8_t> texels[] = {kept.base_color_texels, kept.metallic_roughness_texture.texels,
                                                  kept.normal_texture.texels, kept.occlusion_texture.texels,
                                                  kept.emission_texture.texels};
  for (std::uint8_t texture = 0; texture < 5; ++texture) {
    ASSERT_EQ(texels[texture].size(), 4U) << int{texture};
    EXPECT_EQ(texels[texture][0], texture + 1);
  }
  ASSERT_EQ(kept.emission_texture.coords.size(), 3U);
  EXPECT_EQ(kept.emission_texture.coords[1][0], 1.0F);
}

TEST(CharacterBuilder, KeepsTangentsAndColoursOfVertices) {
  const Triangle triangle;
  MeshView mesh = triangle.view();
  mesh.tangents = triangle.tangents;
  mesh.colors = triangle.colors;
  CharacterBuilder builder = small();
  builder.add_mesh(mesh);
  const Character character = built(builder, {.keep_meshes = true});
  const MeshView kept = character.mesh(0);
  ASSERT_EQ(kept.tangents.size(), 3U);
  EXPECT_EQ(kept.tangents[0], triangle.tangents[0]);
  ASSERT_EQ(kept.colors.size(), 3U);
  EXPECT_EQ(kept.colors[0], triangle.colors[0]);
}

TEST(CharacterBuilder, NamesWhatAMeshLacks) {
  const Triangle triangle;
  struct Case {
    const char* sentence;
    std::function<void(MeshView&)> spoil;
  };
  const Case cases[] = {
      {"one normal, one list of weights", [](MeshView& mesh) { mesh.weights = mesh.weights.first(2); }},
      {"one tangent and one colour", [&](MeshView& mesh) { mesh.tangents = std::span(triangle.tangents).first(2); }},
      {"one tangent and one colour", [&](MeshView& mesh) { mesh.colors = std::span(triangle.colors).first(1); }},
      {"4 bytes times width times height", [&](MeshView& mesh) { mesh.base_color_texels = triangle.texels[0]; }},
      {"4 bytes times width times height",
       [&](MeshView& mesh) {
         mesh.normal_texture = triangle.texture(2);
         mesh.normal_texture.height = 2;
       }},
      {"a texture does not have one place a position",
       [&](MeshView& mesh) {
         mesh.emission_texture = triangle.texture(4);
         mesh.emission_texture.coords = {};
       }},
      {"reads beyond the palette",
       [](MeshView& mesh) {
         static constexpr std::array<std::uint16_t, 4> beyond[3] = {{2}, {2}, {2}};
         mesh.palette_entries = beyond;
       }},
  };
  for (const Case& each : cases) {
    MeshView mesh = triangle.view();
    each.spoil(mesh);
    CharacterBuilder builder = small();
    builder.add_mesh(mesh);
    EXPECT_THAT(fault_of(builder), HasSubstr("mesh \"flag\": ")) << each.sentence;
    EXPECT_THAT(fault_of(builder), HasSubstr(each.sentence));
  }
}

}  // namespace
}  // namespace throng::character_builder_meshes_test
