#include "engine/render/mesh/coverage.h"

#include <array>

#include <gtest/gtest.h>

namespace throng::render::coverage_test {
namespace {

constexpr std::array<std::uint8_t, 8> two_texels = {255, 255, 255, 255, 255, 255, 255, 200};

CrowdMeshData data_of(const MaterialData& material) {
  CrowdMeshData data;
  data.materials = {material};
  data.images = {{2, 1, two_texels}};
  return data;
}

TEST(Coverage, IsOpaqueUnlessTheMaterialSaysOtherwise) {
  MaterialData material;
  material.base_color[3] = 0.0F;
  EXPECT_EQ(coverage_of(data_of(material), 0), Coverage::opaque) << "its alpha is not read";
}

TEST(Coverage, IsOpaqueWhereABlendedMaterialHidesAll) {
  MaterialData material;
  material.blended = true;
  EXPECT_EQ(coverage_of(data_of(material), 0), Coverage::opaque);
  material.base_color[3] = 0.99F;
  EXPECT_EQ(coverage_of(data_of(material), 0), Coverage::blended);
}

TEST(Coverage, ReadsTheAlphaOfTextures) {
  MaterialData material;
  material.base_color_texture.image = 0;
  material.alpha_cutoff = 0.5F;
  EXPECT_EQ(coverage_of(data_of(material), 0), Coverage::opaque) << "200 of 255 is never cut out";
  material.alpha_cutoff = 0.9F;
  EXPECT_EQ(coverage_of(data_of(material), 0), Coverage::cut_out);
}

TEST(Coverage, ReadsTheAlphaOfVerticesOfThatMaterial) {
  constexpr std::array<float, 4> half = {1, 1, 1, 0.5F};
  MaterialData material;
  material.blended = true;
  CrowdMeshData data = data_of(material);
  data.materials.push_back(material);
  MeshPartData part;
  part.colors = half;
  part.material = 1;
  data.parts = {part};
  EXPECT_EQ(coverage_of(data, 0), Coverage::opaque);
  EXPECT_EQ(coverage_of(data, 1), Coverage::blended);
}

}  // namespace
}  // namespace throng::render::coverage_test
