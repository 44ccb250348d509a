#include "engine/render/mesh/surface.h"

#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace throng::render::surface_test {
namespace {

/// Builds two parts, each of one quad and with a material of its own.
struct TwoQuads {
  TwoQuads() {
    for (int material : {1, 0}) {
      MeshPartData part;
      part.positions = positions;
      part.normals = normals;
      part.palette_entries = entries;
      part.weights = weights;
      part.indices = indices;
      part.material = material;
      data.parts.push_back(part);
    }
    data.parts[1].regions = regions;
    data.materials.resize(2);
    data.entry_at_level = {{0, 1, 2}, {0, 0, 2}};
    data.bone_ends = {{{0, 1, 0}, 1}, {{0, 0, 0}, 0}};
  }

  std::vector<float> positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  std::vector<float> normals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  std::vector<std::uint16_t> entries = {0, 1, 2, 0, 1, 0, 0, 0, 2, 1, 0, 0, 1, 2, 0, 0};
  std::vector<float> weights = {0.7F, 0.2F, 0.1F, 0, 1, 0, 0, 0, 0.33333F, 0.33333F, 0.33334F, 0, 0.5F, 0.5F, 0, 0};
  std::vector<std::uint8_t> regions = {0, 1, 2, 4};
  std::vector<std::uint32_t> indices = {0, 1, 2, 0, 2, 3};
  CrowdMeshData data;
};

TEST(Surface, HasOneRunAMaterialWithItsTriangles) {
  const Surface surface = build_surface(TwoQuads().data);
  ASSERT_EQ(surface.pieces[0].runs_by_level.size(), surface.pieces[0].triangles_by_level.size());
  const std::vector<MaterialRun>& runs = surface.pieces[0].runs_by_level[0];
  ASSERT_EQ(runs.size(), 2U);
  for (const MaterialRun& run : runs) {
    ASSERT_EQ(run.index_count, 6U);
    for (std::uint32_t i = run.first_index; i < run.first_index + run.index_count; ++i) {
      EXPECT_EQ(surface.indices[i] < 4, run.material == 1);
    }
  }
  EXPECT_EQ(surface.pieces[0].triangles_by_level[0], 4U);
}

TEST(Surface, TakesMeshLodsThatCameWithTheCharacterAsTheyAre) {
  TwoQuads quads;
  const std::vector<std::uint32_t> one_triangle{0, 2, 3};
  MeshPartData coarse = quads.data.parts[0];
  coarse.indices = one_triangle;
  quads.data.baked_lods.push_back({{coarse}});
  const Surface surface = build_surface(quads.data);
  EXPECT_EQ(surface.pieces[0].triangles_by_level, (std::vector<std::uint32_t>{4, 1}));
  EXPECT_EQ(surface.pieces[0].error_by_level[0], MeshError{});
  EXPECT_FLOAT_EQ(surface.pieces[0].error_by_level[1].surface, 0.125F) << "measured: a part is lost";
  EXPECT_EQ(surface.vertex_count, 8U) << "of the full surface";
  EXPECT_EQ(surface.first_bone_end, 12U) << "its own vertices lie behind them";
  const MaterialRun run = surface.pieces[0].runs_by_level[1].front();
  EXPECT_EQ(run.material, coarse.material);
  for (std::uint32_t i = 0; i < run.index_count; ++i) EXPECT_GE(surface.indices[run.first_index + i], 8U);
}

TEST(Surface, StoresWeightsThatSumToOneExactly) {
  const Surface surface = build_surface(TwoQuads().data);
  for (const SurfaceVertex& vertex : surface.vertices) {
    EXPECT_EQ(std::accumulate(std::begin(vertex.weights), std::end(vertex.weights), 0), 65535);
  }
}

TEST(Surface, SendsDroppedJointsToTheirKeptAncestorAtEachLevel) {
  const Surface surface = build_surface(TwoQuads().data);
  const std::size_t vertices = surface.vertices.size();
  ASSERT_EQ(surface.entries.size(), 2 * vertices);
  EXPECT_EQ(surface.entries[0], (PaletteEntries{0, 1, 2, 0}));
  EXPECT_EQ(surface.entries[vertices], (PaletteEntries{0, 0, 2, 0}));
}

TEST(Surface, MarksVerticesWithoutRegionAsUntinted) {
  const Surface surface = build_surface(TwoQuads().data);
  EXPECT_EQ(surface.vertices[0].region, untinted_region);
  EXPECT_EQ(surface.vertices[4 + 3].region, 4);
}

TEST(Surface, PutsEndsOfBonesBehindItsVerticesMovedByTheirEntryAlone) {
  const Surface surface = build_surface(TwoQuads().data);
  EXPECT_EQ(surface.first_bone_end, 8U);
  EXPECT_EQ(surface.bone_end_count, 2U);
  EXPECT_EQ(surface.vertices[8].weights[0], 65535);
  EXPECT_EQ(surface.entries[8][0], 1);
  EXPECT_EQ(surface.entries[surface.vertices.size() + 8][0], 0);
}

TEST(Surface, HasNoTangentsNorFurtherCoordinatesWhereNoPartHasAny) {
  const Surface surface = build_surface(TwoQuads().data);
  EXPECT_TRUE(surface.tangents.empty());
  EXPECT_TRUE(surface.detail_coords.empty());
}

TEST(Surface, HasTangentsAndFurtherCoordinatesAtEachVertexWhereAPartHasThem) {
  const std::vector<float> tangents = {1, 0, 0, -1, 0, 1, 0, 1, 1, 0, 0, 1, 0, 0, -1, 1};
  const std::vector<float> coords = {0, 0, 1, 0, 1, 1, 0, 1}, others = {5, 6, 5, 6, 5, 6, 7, 8};
  TwoQuads quads;
  quads.data.parts[1].tangents = tangents;
  quads.data.parts[1].texture_coords = coords;
  quads.data.parts[1].normal_coords = others;
  quads.data.baked_lods.push_back({{quads.data.parts[0], quads.data.parts[1]}});
  const Surface surface = build_surface(quads.data);
  ASSERT_EQ(surface.tangents.size(), surface.vertices.size()) << "bone ends too";
  ASSERT_EQ(surface.detail_coords.size(), surface.vertices.size());
  EXPECT_EQ(surface.tangents[0], PackedTangent{});
  for (const std::size_t first : {4U, 12U}) {
    EXPECT_EQ(surface.tangents[first], (PackedTangent{32767, 0, 0, -32767}));
    EXPECT_EQ(surface.tangents[first + 3], (PackedTangent{0, 0, -32767, 32767}));
    EXPECT_EQ(surface.detail_coords[first + 3].normal, (TextureCoord{7, 8}));
    EXPECT_EQ(surface.detail_coords[first + 2].occlusion, (TextureCoord{1, 1})) << "those of the base colour";
  }
}

}  // namespace
}  // namespace throng::render::surface_test
