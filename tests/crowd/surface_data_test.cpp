#include "engine/crowd/surface_data.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::surface_data_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

anim::SkinnedMesh mesh_of_two_coords() {
  anim::SkinnedMesh mesh;
  mesh.positions = mesh.normals = {{1, 2, 3}};
  mesh.tangents = {{1, 0, 0, -1}};
  mesh.texture_coords = {{{0.25F, 0.5F}}, {{0.75F, 1.0F}}};
  return mesh;
}

TEST(SurfaceData, GivesEachTextureTheCoordinatesThatItReads) {
  anim::Material material;
  material.base_color_texture = {.image = 0, .coords = 0};
  material.normal_texture = {.image = 1, .coords = 0};
  material.occlusion_texture = {.image = 2, .coords = 1};
  const anim::SkinnedMesh mesh = mesh_of_two_coords();
  const render::MeshPartData part = part_data(mesh, material);
  EXPECT_THAT(part.texture_coords, ElementsAre(0.25F, 0.5F));
  EXPECT_THAT(part.normal_coords, IsEmpty()) << "those of the base colour";
  EXPECT_THAT(part.occlusion_coords, ElementsAre(0.75F, 1.0F));
  EXPECT_THAT(part.emission_coords, IsEmpty());
  EXPECT_THAT(part.tangents, ElementsAre(1.0F, 0.0F, 0.0F, -1.0F));
}

TEST(SurfaceData, LetsAnyTextureLeadWithoutABaseColorTexture) {
  anim::Material material;
  material.normal_texture = {.image = 0, .coords = 1};
  const anim::SkinnedMesh mesh = mesh_of_two_coords();
  const render::MeshPartData part = part_data(mesh, material);
  EXPECT_THAT(part.texture_coords, ElementsAre(0.75F, 1.0F));
  EXPECT_THAT(part.normal_coords, IsEmpty());
}

TEST(SurfaceData, TellsDrawingAllThatLightReads) {
  anim::Material material;
  material.metallic = 0.25F;
  material.roughness = 0.5F;
  material.normal_scale = 2.0F;
  material.occlusion_strength = 0.75F;
  material.metallic_roughness_texture = {.image = 1, .wrap_u = anim::Wrap::clamp};
  material.normal_texture.image = 2;
  material.occlusion_texture.image = 3;
  render::CrowdMeshData drawn;
  add_materials({&material, 1}, {}, drawn);
  ASSERT_EQ(drawn.materials.size(), 1U);
  const render::MaterialData& data = drawn.materials.front();
  EXPECT_EQ(data.metallic, 0.25F);
  EXPECT_EQ(data.roughness, 0.5F);
  EXPECT_EQ(data.normal_scale, 2.0F);
  EXPECT_EQ(data.occlusion_strength, 0.75F);
  EXPECT_EQ(data.metallic_roughness_texture.image, 1);
  EXPECT_EQ(data.metallic_roughness_texture.wrap_u, 33071);
  EXPECT_EQ(data.normal_texture.image, 2);
  EXPECT_EQ(data.occlusion_texture.image, 3);
}

}  // namespace
}  // namespace throng::surface_data_test
