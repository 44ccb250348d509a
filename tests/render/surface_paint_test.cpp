#include "engine/render/mesh/surface_paint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "engine/render/mesh/mesh_error.h"

namespace throng::render::surface_paint_test {
namespace {

constexpr std::array<std::uint8_t, 8> red_and_blue = {255, 0, 0, 255, 0, 0, 255, 255};
constexpr int clamp = 33071, mirror = 33648, repeat = 10497;

/// A triangle of one material, all of whose vertices read the texture at the same place.
struct Triangle {
  explicit Triangle(const MaterialData& material, float u = 0.0F) {
    SurfaceVertex vertex{};
    vertex.texture_coord[0] = u;
    for (std::uint16_t& channel : vertex.color) channel = 65535;
    surface.vertices.assign(3, vertex);
    data.materials = {material};
    data.images = {{2, 1, red_and_blue}};
  }

  PointLook look() const { return SurfacePaint(surface, materials, data).look({.vertices = {0, 1, 2}}); }

  Surface surface;
  std::vector<int> materials = {0, 0, 0};
  CrowdMeshData data;
};

bool is_red(const PointLook& look) { return look.color.r > look.color.b; }

TEST(SurfacePaint, WrapsTexturesAsTheirSamplersDo) {
  const auto red_at = [](float u, int wrap) {
    MaterialData material;
    material.base_color_texture = {.image = 0, .wrap_u = wrap};
    return is_red(Triangle(material, u).look());
  };
  EXPECT_TRUE(red_at(1.25F, repeat));
  EXPECT_FALSE(red_at(1.25F, mirror));
  EXPECT_FALSE(red_at(1.25F, clamp));
  EXPECT_TRUE(red_at(-0.25F, clamp));
  EXPECT_TRUE(red_at(-0.25F, mirror));
  EXPECT_TRUE(red_at(NAN, repeat)) << "and reads no memory that is not the texture's";
}

TEST(SurfacePaint, AddsWhatShinesByItself) {
  MaterialData material;
  for (int i = 0; i < 3; ++i) material.base_color[i] = 0.0F;
  material.emission[2] = 1.0F;
  Triangle triangle(material);
  EXPECT_EQ(triangle.look().color, glm::vec3(0.0F, 0.0F, 1.0F));
  triangle.data.materials[0].emission_texture.image = 0;
  EXPECT_EQ(triangle.look().color, glm::vec3(0.0F)) << "the texture is red at 0";
  triangle.surface.detail_coords.assign(3, DetailCoords{});
  for (DetailCoords& coords : triangle.surface.detail_coords) coords.emission = {0.75F, 0.0F};
  EXPECT_EQ(triangle.look().color, glm::vec3(0.0F, 0.0F, 1.0F)) << "and blue where its own coordinates are";
}

TEST(SurfacePaint, SaysWhatIsSeenThrough) {
  MaterialData material;
  material.blended = true;
  EXPECT_FALSE(Triangle(material).look().seen_through);
  material.base_color[3] = 0.3F;
  EXPECT_TRUE(Triangle(material).look().seen_through);
  EXPECT_FALSE(Triangle(material).look().cut_out);
  material.base_color[3] = 0.0F;
  EXPECT_TRUE(Triangle(material).look().cut_out);
}

/// Adds an octahedron.
void add_octahedron(float radius, std::vector<float>& positions, std::vector<std::uint32_t>& indices) {
  const auto first = static_cast<std::uint32_t>(positions.size() / 3);
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {radius, -radius}) {
      for (int i = 0; i < 3; ++i) positions.push_back(i == axis ? side : 0.0F);
    }
  }
  for (std::uint32_t octant = 0; octant < 8; ++octant) {
    const std::uint32_t x = first + (octant & 1U), y = first + 2 + (octant >> 1U & 1U), z = first + 4 + (octant >> 2U);
    const bool turned = ((octant ^ octant >> 1U ^ octant >> 2U) & 1U) != 0;
    indices.insert(indices.end(), {x, turned ? z : y, turned ? y : z});
  }
}

TEST(MeshError, CountsWhatIsSeenThroughAShell) {
  std::vector<float> positions;
  std::vector<std::uint32_t> indices;
  add_octahedron(1.0F, positions, indices);  // a glass shell
  const std::size_t shell = indices.size();
  add_octahedron(0.5F, positions, indices);
  const std::vector<SkinInfluences> influences(12);
  const std::vector<std::uint32_t> belongs_to(12, 0);
  const SkinnedSurfaceView view{positions, influences, belongs_to, indices, {}};
  MaterialData glass;
  glass.blended = true;
  Triangle paint({});
  paint.surface.vertices.resize(12, paint.surface.vertices[0]);
  paint.data.materials.push_back(glass);
  paint.materials.assign(12, 0);
  std::fill_n(paint.materials.begin(), 6, 1);
  const std::span shell_alone = std::span(indices).first(shell);
  const auto error = [&](float alpha) {
    paint.data.materials[1].base_color[3] = alpha;
    const SurfacePaint colors(paint.surface, paint.materials, paint.data);
    return MeshErrorMeter(view, &colors, {}).error_of(shell_alone).surface;
  };
  EXPECT_LT(error(1.0F), 0.01F) << "nobody sees what is inside";
  EXPECT_GT(error(0.3F), 0.1F) << "what was inside is lost";
}

}  // namespace
}  // namespace throng::render::surface_paint_test
