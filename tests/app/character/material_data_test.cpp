#include "app/character/material_data.h"

#include <array>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::app::material_data_test {
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

TEST(MaterialData, GivesEachTextureTheCoordinatesThatItReads) {
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

TEST(MaterialData, LetsAnyTextureLeadWithoutABaseColorTexture) {
  anim::Material material;
  material.normal_texture = {.image = 0, .coords = 1};
  const anim::SkinnedMesh mesh = mesh_of_two_coords();
  const render::MeshPartData part = part_data(mesh, material);
  EXPECT_THAT(part.texture_coords, ElementsAre(0.75F, 1.0F));
  EXPECT_THAT(part.normal_coords, IsEmpty());
}

TEST(MaterialData, HasAllChannelsOfTheWardrobe) {
  auto file = import_to_draw(THRONG_SOURCE_DIR "/assets/wardrobe.glb");
  ASSERT_TRUE(file) << file.error().message;
  std::array<std::set<std::size_t>, 5> widths;  // floats a vertex
  anim::visit_surfaces(file->models.front(), [&](const std::vector<anim::SkinnedMesh>& meshes) {
    for (const anim::SkinnedMesh& mesh : meshes) {
      const render::MeshPartData part = part_data(mesh, {});
      const std::array channels{part.shapes, part.hair, part.faces, part.trims, part.texture_coords};
      for (std::size_t i = 0; i < channels.size(); ++i) widths[i].insert(channels[i].size() / mesh.positions.size());
    }
  });
  EXPECT_THAT(widths,
              ElementsAre(ElementsAre(3), ElementsAre(0, 2), ElementsAre(0, 4), ElementsAre(0, 1), ElementsAre(0, 2)));
}

TEST(MaterialData, TellsDrawingAllThatLightReads) {
  anim::Material material;
  material.metallic = 0.25F;
  material.roughness = 0.5F;
  material.normal_scale = 2.0F;
  material.occlusion_strength = 0.75F;
  material.metallic_roughness_texture = {.image = 1, .wrap_u = anim::Wrap::clamp};
  material.normal_texture.image = 2;
  material.occlusion_texture.image = 3;
  const render::MaterialData data = material_data(material);
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
}  // namespace throng::app::material_data_test
