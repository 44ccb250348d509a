#include "engine/render/mesh/mesh_lod.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <glm/ext/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace throng::render::mesh_lod_test {
namespace {

constexpr double full_turn = 6.283185307179586;

/// Builds an arm with an elbow: a closed tube along x from 0 to 2, of radius 0.1, moved by one joint below x = 1 and by
/// another above.
struct Arm {
  static constexpr int rings = 41;
  static constexpr int sides = 16;

  Arm() {
    for (int ring = 0; ring < rings; ++ring) {
      for (int side = 0; side < sides; ++side) add_vertex(2.0 * ring / (rings - 1), side);
    }
    for (int ring = 0; ring + 1 < rings; ++ring) {
      for (int side = 0; side < sides; ++side) add_quad(ring, side);
    }
    add_cap(0, false);
    add_cap(rings - 1, true);
  }

  void add_vertex(double x, int side) {
    const double angle = full_turn * side / sides;
    for (const double value : {x, 0.1 * std::cos(angle), 0.1 * std::sin(angle)}) {
      positions.push_back(static_cast<float>(value));
    }
    const auto lower = static_cast<float>(std::clamp((x - 0.9) / 0.2, 0.0, 1.0));
    influences.push_back({{0, 1, 0, 0}, {1.0F - lower, lower, 0.0F, 0.0F}});
    belongs_to.push_back(x < 0.5 ? 1 : 0);
  }

  static std::uint32_t at(int ring, int side) { return static_cast<std::uint32_t>(ring * sides + side % sides); }

  void add_quad(int ring, int side) {
    const std::uint32_t a = at(ring, side), b = at(ring + 1, side), c = at(ring + 1, side + 1), d = at(ring, side + 1);
    indices.insert(indices.end(), {a, c, b, a, d, c});
  }

  void add_cap(int ring, bool far) {
    for (int side = 1; side + 1 < sides; ++side) {
      const std::uint32_t a = at(ring, 0), b = at(ring, side), c = at(ring, side + 1);
      indices.insert(indices.end(), {a, far ? b : c, far ? c : b});
    }
  }

  SkinnedSurfaceView view() const { return {positions, influences, belongs_to, indices, {}}; }
  float x(std::uint32_t vertex) const { return positions[vertex * 3UL]; }

  std::vector<float> positions;
  std::vector<SkinInfluences> influences;
  std::vector<std::uint32_t> belongs_to;
  std::vector<std::uint32_t> indices;
};

std::vector<MeshLod> lods_of(const SkinnedSurfaceView& view, const PosedPalettes& poses = {}) {
  return build_mesh_lods(view, MeshErrorMeter(view, nullptr, poses));
}

TEST(MeshLods, HaveClearlyFewerTrianglesEachAndErrorsThatGrow) {
  const Arm arm;
  const std::vector<MeshLod> lods = lods_of(arm.view());
  ASSERT_GE(lods.size(), 2U);
  ASSERT_LE(lods.size(), largest_mesh_lod_count);
  EXPECT_EQ(lods[0].indices, arm.indices);
  EXPECT_EQ(lods[0].error, MeshError{});
  for (std::size_t lod = 1; lod < lods.size(); ++lod) {
    EXPECT_LE(lods[lod].indices.size() * 10, lods[lod - 1].indices.size() * 8) << lod;
    EXPECT_GE(lods[lod].error.surface, lods[lod - 1].error.surface);
    EXPECT_GT(lods[lod].error.surface, 0.0F);
  }
  EXPECT_LE(lods.back().indices.size() * 5, arm.indices.size()) << "serves those who are small on screen";
}

TEST(MeshLods, AreMeasuredInThePosesThatTheCharacterTakes) {
  const Arm arm;
  const glm::mat4x3 rest(1.0F);
  const glm::mat4x3 bent(
      glm::translate(glm::rotate(glm::translate(glm::mat4(1), {1, 0, 0}), 2.0F, {0, 0, 1}), glm::vec3(-1, 0, 0)));
  const float straight = lods_of(arm.view(), {{rest, rest}}).back().error.surface;
  EXPECT_GT(lods_of(arm.view(), {{rest, rest}, {rest, bent}}).back().error.surface, straight);
}

TEST(MeshLods, StayClosed) {
  const Arm arm;
  for (const MeshLod& lod : lods_of(arm.view())) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed_edges;
    for (std::size_t i = 0; i < lod.indices.size(); ++i) {
      const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
      ++directed_edges[{lod.indices[i], lod.indices[next]}];
    }
    for (const auto& [edge, count] : directed_edges) {
      EXPECT_EQ(count, 1);
      EXPECT_EQ(directed_edges.count({edge.second, edge.first}), 1U);
    }
  }
}

TEST(MeshLods, KeepVerticesInsideAnElbow) {
  // A straight tube needs no vertex between its ends, but a bent one without a ring at the elbow folds flat.
  const Arm arm;
  const std::vector<MeshLod> lods = lods_of(arm.view());
  const std::vector<std::uint32_t>& coarse = lods.back().indices;
  const auto at_elbow = std::ranges::count_if(
      coarse, [&](std::uint32_t vertex) { return arm.x(vertex) > 0.85F && arm.x(vertex) < 1.15F; });
  EXPECT_GE(at_elbow, 3);
}

TEST(MeshLods, OfAMeshTooSmallToSimplifyAreFewer) {
  const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::vector<SkinInfluences> influences(4, SkinInfluences{{0, 0, 0, 0}, {1, 0, 0, 0}});
  const std::vector<std::uint32_t> belongs_to(4, 0);
  const std::vector<std::uint32_t> indices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  EXPECT_EQ(lods_of({positions, influences, belongs_to, indices, {}}).size(), 1U);
}

TEST(MeshLods, OfNothingAreOneEmptyOne) {
  const std::vector<MeshLod> lods = lods_of({});
  ASSERT_EQ(lods.size(), 1U);
  EXPECT_TRUE(lods[0].indices.empty());
}

TEST(MeshLods, SurviveTrianglesWithoutArea) {
  Arm arm;
  arm.indices.insert(arm.indices.end(), {0, 0, 0, 1, 2, 1});
  EXPECT_GE(lods_of(arm.view()).size(), 2U);
}

std::vector<glm::vec3> with_a_dark_ring(const Arm& arm, float from, float to) {
  std::vector<glm::vec3> colors;
  for (std::uint32_t vertex = 0; vertex < arm.influences.size(); ++vertex) {
    colors.emplace_back(arm.x(vertex) > from && arm.x(vertex) < to ? 0.1F : 0.9F);
  }
  return colors;
}

TEST(MeshLods, KeepColoursWhereTheyAre) {
  // Nothing but its colour tells the ring from the rest of the upper arm.
  const Arm arm;
  const std::vector<glm::vec3> colors = with_a_dark_ring(arm, 0.65F, 0.75F);
  SkinnedSurfaceView view = arm.view();
  view.colors = colors;
  const std::vector<MeshLod> lods = lods_of(view);
  const auto is_dark = [&](std::uint32_t vertex) { return colors[vertex].r < 0.5F; };
  constexpr float lost = 0.05F;  // half of the ring's width
  for (const MeshLod& lod : lods) {
    if (lod.error.surface >= lost) break;
    EXPECT_GE(std::ranges::count_if(lod.indices, is_dark), 3) << lod.indices.size();
  }
  EXPECT_LT(lods[2].error.surface, lost);
}

TEST(MeshLods, KeepMoreOfAFaceThanOfTheRest) {
  const Arm arm;
  std::vector<std::uint8_t> face;
  for (std::uint32_t vertex = 0; vertex < arm.influences.size(); ++vertex) face.push_back(arm.x(vertex) > 1.5F ? 1 : 0);
  const auto face_triangles = [&](const SkinnedSurfaceView& view) {
    SurfaceSimplifier simplifier(view);
    simplifier.reduce_to(300, 1.0);
    const std::vector<std::uint32_t> indices = simplifier.indices();
    return std::ranges::count_if(indices, [&](std::uint32_t vertex) { return face[vertex] != 0; }) / 3;
  };
  SkinnedSurfaceView view = arm.view();
  const auto without = face_triangles(view);
  view.face = face;
  EXPECT_GT(face_triangles(view), without * 5 / 4);
}

TEST(MeshLods, KnowTheErrorOfTheFaceAlone) {
  const Arm arm;
  std::vector<std::uint8_t> face(arm.influences.size(), 0);
  SkinnedSurfaceView view = arm.view();
  const MeshLod without = lods_of(view).back();
  EXPECT_EQ(without.error.face, without.error.surface) << "where no face is known";
  for (std::uint32_t vertex = 0; vertex < arm.influences.size(); ++vertex) face[vertex] = arm.x(vertex) > 1.8F ? 1 : 0;
  view.face = face;
  const MeshLod with = lods_of(view).back();
  EXPECT_LT(with.error.face, with.error.surface);
}

MeshError alike(float error) { return {error, error}; }

TEST(PickMeshLod, IsTheCoarsestWithinTheLimit) {
  const std::array errors{alike(0.0F), alike(0.01F), alike(0.03F), alike(0.1F)};
  EXPECT_EQ(pick_mesh_lod(errors, alike(0.0F)), 0);
  EXPECT_EQ(pick_mesh_lod(errors, alike(0.009F)), 0);
  EXPECT_EQ(pick_mesh_lod(errors, alike(0.01F)), 1);
  EXPECT_EQ(pick_mesh_lod(errors, alike(0.05F)), 2);
  EXPECT_EQ(pick_mesh_lod(errors, alike(1.0F)), 3);
}

TEST(PickMeshLod, KeepsToBothLimits) {
  const std::array errors{MeshError{}, MeshError{0.02F, 0.01F}, MeshError{0.05F, 0.04F}};
  EXPECT_EQ(pick_mesh_lod(errors, {.surface = 1.0F, .face = 0.02F}), 1);
  EXPECT_EQ(pick_mesh_lod(errors, {.surface = 0.02F, .face = 1.0F}), 1);
}

TEST(PickMeshLod, IsTheFullMeshWhereThereIsNoOther) {
  EXPECT_EQ(pick_mesh_lod(std::array{MeshError{}}, alike(100.0F)), 0);
}

}  // namespace
}  // namespace throng::render::mesh_lod_test
