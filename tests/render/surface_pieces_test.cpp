// The pieces that agents wear, beside the surface that is all of a character.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "engine/render/mesh/mesh_parts.h"
#include "engine/render/mesh/surface.h"

namespace throng::render::surface_pieces_test {
namespace {

/// A flat square of so many cells a side.
struct Square {
  explicit Square(std::uint32_t cells) {
    const std::uint32_t side = cells + 1;
    for (std::uint32_t i = 0; i < side * side; ++i) {
      const auto x = static_cast<float>(i % side), y = static_cast<float>(i / side);
      positions.insert(positions.end(), {x / static_cast<float>(cells), y / static_cast<float>(cells), 0.0F});
      normals.insert(normals.end(), {0, 0, 1});
      entries.insert(entries.end(), {0, 0, 0, 0});
      weights.insert(weights.end(), {1, 0, 0, 0});
      trims.push_back(1.0F);
      faces.insert(faces.end(), {1.0F, -1.0F, 0.5F, 0.0F});
    }
    for (std::uint32_t i = 0; i < cells * cells; ++i) {
      const std::uint32_t a = i / cells * side + i % cells, b = a + side;
      indices.insert(indices.end(), {a, a + 1, b, a + 1, b + 1, b});
    }
  }
  MeshPartData part() const {
    MeshPartData part;
    part.positions = positions;
    part.normals = normals;
    part.trims = trims;
    part.faces = faces;
    part.palette_entries = entries;
    part.weights = weights;
    part.indices = indices;
    return part;
  }
  std::uint32_t triangles() const { return static_cast<std::uint32_t>(indices.size() / 3); }
  std::size_t vertices() const { return positions.size() / 3; }

  std::vector<float> positions, normals, weights, trims, faces;
  std::vector<std::uint16_t> entries;
  std::vector<std::uint32_t> indices;
};

struct Wardrobe {
  Wardrobe() {
    data.parts = {whole.part()};
    data.materials.resize(1);
    data.entry_at_level = {{0}};
    data.poses = {{glm::mat4x3(1.0F)}};
    data.bone_ends = {{{0, 1, 0}, 0}};
  }
  Square whole{1}, fine{8}, middle{4}, coarse{2};
  CrowdMeshData data;
};

TEST(SurfacePieces, HaveTheLevelsThatAreStated) {
  Wardrobe wardrobe;
  wardrobe.data.pieces = {{.levels = {{{wardrobe.fine.part()}, 0.0F}, {{wardrobe.middle.part()}, 0.01F}}}};
  const Surface surface = build_surface(wardrobe.data);
  ASSERT_EQ(surface.pieces.size(), 2U);
  const SurfacePiece& piece = surface.pieces[1];
  EXPECT_EQ(piece.triangles_by_level, (std::vector{wardrobe.fine.triangles(), wardrobe.middle.triangles()}));
  const std::size_t first = wardrobe.whole.vertices(), of_fine = wardrobe.fine.vertices();
  EXPECT_EQ(surface.first_bone_end, first + of_fine + wardrobe.middle.vertices());
  EXPECT_EQ(surface.entries.size(), surface.vertices.size());
  for (std::size_t level = 0; level < 2; ++level) {
    const MaterialRun run = piece.runs_by_level[level].front();
    EXPECT_EQ(run.index_count, 3 * piece.triangles_by_level[level]);
    for (std::uint32_t i = run.first_index; i < run.first_index + run.index_count; ++i) {
      EXPECT_EQ(surface.indices[i] >= first + of_fine, level == 1);
      EXPECT_GE(surface.indices[i], first);
    }
  }
  const SurfaceVertex& vertex = surface.vertices[first];
  EXPECT_EQ(vertex.trim, 255);
  EXPECT_EQ(vertex.face[0], 127);
  EXPECT_EQ(vertex.face[1], -127);
}

TEST(SurfacePieces, ShareTheVerticesOfALevelThatIsRepeated) {
  Wardrobe wardrobe;
  const MeshPartData part = wardrobe.fine.part();
  wardrobe.data.pieces = {{.levels = {{{part}, 0.0F}, {{part}, 0.0F}, {{wardrobe.coarse.part()}, 0.03F}}}};
  const Surface surface = build_surface(wardrobe.data);
  EXPECT_EQ(surface.first_bone_end, wardrobe.whole.vertices() + wardrobe.fine.vertices() + wardrobe.coarse.vertices());
  EXPECT_EQ(surface.pieces[1].triangles_by_level[1], wardrobe.fine.triangles());
  std::size_t parts = 0;
  for_each_part(wardrobe.data, [&](const MeshPartData&) { ++parts; });
  EXPECT_EQ(parts, 3U) << "with the character itself";
}

TEST(SurfacePieces, AloneAreSimplified) {
  Wardrobe wardrobe;
  wardrobe.data.pieces = {{.levels = {{{wardrobe.fine.part()}, 0.0F}}}};
  const SurfacePiece piece = build_surface(wardrobe.data).pieces[1];
  ASSERT_GT(piece.triangles_by_level.size(), 1U);
  EXPECT_LT(piece.triangles_by_level.back(), wardrobe.fine.triangles() / 4) << "it is flat";
}

TEST(SurfacePieces, StandForMeshLodsThatFollowTheirLastLevel) {
  Wardrobe wardrobe;
  const MeshPartData fine = wardrobe.fine.part(), middle = wardrobe.middle.part(), coarse = wardrobe.coarse.part();
  wardrobe.data.pieces = {{.levels = {{{fine}, 0.0F}, {{middle}, 0.008F}}},
                          {.levels = {{{fine}, 0.075F}, {{middle}, 0.12F}, {{coarse}, 0.2F}}, .is_silhouette = true}};
  const Surface surface = build_surface(wardrobe.data);
  const SurfacePiece &piece = surface.pieces[1], &silhouette = surface.pieces[2];
  EXPECT_EQ(piece.level_at(0), 0U);
  EXPECT_EQ(piece.level_at(3), 1U);
  EXPECT_EQ(piece.lod_count(), 2U);
  EXPECT_EQ(silhouette.level_at(first_silhouette_lod), 0U);
  EXPECT_EQ(silhouette.level_at(5), 1U);
  EXPECT_EQ(silhouette.lod_count(), 7U);
  EXPECT_FLOAT_EQ(piece.error_by_level[1].surface, 0.008F);
  EXPECT_FLOAT_EQ(silhouette.error_by_level[2].surface, 0.2F);
}

TEST(SurfacePieces, AreOffOnAFaceOnlyWhereTheyLieOnOne) {
  Wardrobe wardrobe;
  const MeshPartData fine = wardrobe.fine.part(), middle = wardrobe.middle.part();
  wardrobe.data.pieces = {{.levels = {{{fine}, 0.0F}, {{middle}, 0.008F}}}};
  for (const std::uint8_t on_face : {std::uint8_t{0}, std::uint8_t{1}}) {
    wardrobe.data.face_entries = {on_face};
    const Surface surface = build_surface(wardrobe.data);
    EXPECT_FLOAT_EQ(surface.pieces[1].error_by_level[1].face, on_face == 1 ? 0.008F : 0.0F);
  }
}

}  // namespace
}  // namespace throng::render::surface_pieces_test
