#include "engine/anim/import/facing.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "tests/import/test_files.h"

namespace throng::import::testing::facing_test {
namespace {

using nlohmann::json;
using ::testing::SizeIs;

glm::vec3 normal_of(const std::vector<glm::vec3>& positions, const std::uint32_t* corners) {
  return glm::cross(positions[corners[1]] - positions[corners[0]], positions[corners[2]] - positions[corners[0]]);
}

/// Two triangles of a folded sheet, which share an edge, and a third in the plane of the second.
anim::SkinnedMesh folded_sheet() {
  anim::SkinnedMesh sheet;
  sheet.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}};
  sheet.colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 0, 1}, {0, 1, 1, 1}};
  sheet.texture_coords = {{{0, 0}, {1, 0}, {0, 1}, {0, 0.5F}, {1, 0.5F}}};
  sheet.channels = {{"_TWO", 2, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}}};
  sheet.palette_entries.assign(5, glm::u16vec4(0));
  sheet.weights.assign(5, glm::vec4(1, 0, 0, 0));
  sheet.indices = {0, 1, 2, 0, 3, 1, 1, 3, 4};
  return sheet;
}

TEST(FlatShading, GivesEveryTriangleItsOwnNormalAndKeepsItsCorners) {
  const anim::SkinnedMesh before = folded_sheet();
  anim::SkinnedMesh after = before;
  shade_flat(after);
  EXPECT_THAT(after.positions, SizeIs(7)) << "the edge is doubled; the triangles in one plane share their corners";
  ASSERT_EQ(after.indices.size(), before.indices.size());
  for (std::size_t i = 0; i < after.indices.size(); ++i) {
    const std::uint32_t now = after.indices[i], then = before.indices[i];
    EXPECT_EQ(after.positions[now], before.positions[then]);
    EXPECT_EQ(after.colors[now], before.colors[then]);
    EXPECT_EQ(after.texture_coords[0][now], before.texture_coords[0][then]);
    EXPECT_EQ(anim::find_channel(after, "_TWO")[now * 2 + 1], anim::find_channel(before, "_TWO")[then * 2 + 1]);
    const glm::vec3 normal = glm::normalize(normal_of(after.positions, &after.indices[i / 3 * 3]));
    EXPECT_LT(glm::distance(after.normals[now], normal), 1e-6F);
  }
}

TEST(FlatShading, LetsMorphsMoveEveryCopyOfAVertex) {
  anim::SkinnedMesh sheet = folded_sheet();
  sheet.morph_deltas = {{.vertex = 1, .morph = 7, .position = {0, 2, 0}, .normal = {}},
                        {.vertex = 4, .morph = 8, .position = {0, 3, 0}, .normal = {}}};
  const std::vector<glm::vec3> before = sheet.positions;
  shade_flat(sheet);
  std::vector<std::uint32_t> morphs;
  for (const anim::MorphDelta& delta : sheet.morph_deltas) {
    morphs.push_back(delta.morph);
    EXPECT_EQ(sheet.positions[delta.vertex], before[delta.morph == 7 ? 1 : 4]);
  }
  EXPECT_THAT(morphs, ::testing::UnorderedElementsAre(7U, 7U, 8U)) << "vertex 1 is on the edge, which is doubled";
}

TEST(FlatShading, IsWhatAFileWithoutNormalsGets) {
  const anim::ImportedFile file = import_good(data_path("features/data-uri.gltf"));
  const anim::SkinnedMesh& mesh = file.models.at(0).meshes.at(0);
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  EXPECT_GT(mesh.positions.size(), 44U) << "of the file";
  EXPECT_EQ(mesh.weights.size(), mesh.positions.size());
}

TEST(Tangents, PointAlongTheTextureAndSayWhetherItIsMirrored) {
  anim::SkinnedMesh sheet = folded_sheet();
  sheet.indices = {0, 1, 2};
  anim::Material material;
  material.normal_texture.image = 0;
  shade_flat(sheet);
  add_tangents(sheet, material);
  ASSERT_THAT(sheet.tangents, SizeIs(sheet.positions.size()));
  EXPECT_EQ(sheet.tangents[0], glm::vec4(1, 0, 0, -1)) << "v grows upwards, as in the mirror image of an image";
  for (glm::vec2& place : sheet.texture_coords[0]) place.x = -place.x;
  sheet.tangents.clear();
  add_tangents(sheet, material);
  EXPECT_EQ(sheet.tangents[0], glm::vec4(-1, 0, 0, 1)) << "an image that stands on its head";
}

TEST(Tangents, KeepATextureApartFromItsMirrorImage) {
  anim::SkinnedMesh sheet;
  sheet.positions = {{-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {1, 0, 0}};
  sheet.normals.assign(4, {0, 0, 1});
  sheet.texture_coords = {{{0, 0.5F}, {1, 0}, {1, 1}, {0, 0.5F}}};
  sheet.palette_entries.assign(4, glm::u16vec4(0));
  sheet.weights.assign(4, glm::vec4(1, 0, 0, 0));
  sheet.indices = {0, 2, 1, 3, 1, 2};
  anim::Material material;
  material.normal_texture.image = 0;
  add_tangents(sheet, material);
  ASSERT_THAT(sheet.tangents, SizeIs(6)) << "both ends of the seam twice";
  for (std::size_t i = 0; i < 6; ++i) {
    const float side = i < 3 ? 1.0F : -1.0F;
    EXPECT_EQ(sheet.tangents[sheet.indices[i]], glm::vec4(side, 0, 0, side)) << i;
  }
  EXPECT_THAT(sheet.normals, SizeIs(6));
  EXPECT_THAT(sheet.weights, SizeIs(6));
}

TEST(Tangents, AreLeftOutWithoutANormalTexture) {
  anim::SkinnedMesh sheet = folded_sheet();
  shade_flat(sheet);
  add_tangents(sheet, {});
  EXPECT_TRUE(sheet.tangents.empty());
}

/// The sum of the triangles' volumes below the origin, as the rest pose draws them. Its sign says which way they face.
double drawn_volume(const anim::Model& model) {
  const auto palette = anim::reference_pose(model.skeleton, nullptr, 0.0).palette;
  double volume = 0.0;
  for (const anim::SkinnedMesh& mesh : model.meshes) {
    std::vector<glm::vec3> drawn;
    for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
      glm::dvec3 sum(0.0);
      for (glm::length_t i = 0; i < 4; ++i) {
        sum += static_cast<double>(mesh.weights[vertex][i]) *
               glm::dvec3(palette[mesh.palette_entries[vertex][i]] * glm::dvec4(glm::dvec3(mesh.positions[vertex]), 1));
      }
      drawn.emplace_back(sum);
    }
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      volume += static_cast<double>(glm::dot(drawn[mesh.indices[i]], normal_of(drawn, &mesh.indices[i])));
    }
  }
  return volume;
}

json mirrored_document() {
  json document = read_json(data_path("features/data-uri.gltf"));
  document["nodes"].push_back({{"scale", {-1, 1, 1}}, {"children", document["scenes"][0]["nodes"]}});
  document["scenes"][0]["nodes"] = json::array({document["nodes"].size() - 1});
  return document;
}

double volume_of(const json& document) {
  const TemporaryFolder folder;
  return drawn_volume(import_good(folder.write("model.gltf", document.dump())).models.at(0));
}

TEST(MirroredCharacters, AreRightSideOut) {
  const double plain = volume_of(read_json(data_path("features/data-uri.gltf")));
  ASSERT_GT(std::abs(plain), 0.1);
  EXPECT_NEAR(volume_of(mirrored_document()), plain, std::abs(plain) * 1e-4);
}

TEST(MirroredCharacters, MayHavePartsThatAreNot) {
  anim::SkinnedMesh sheet = folded_sheet();
  sheet.palette_entries[4] = glm::u16vec4(1);
  sheet.palette_entries[3] = glm::u16vec4(1);
  const anim::SkinnedMesh before = sheet;
  turn_mirrored_triangles(sheet, {false, true});
  EXPECT_EQ(sheet.indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 3, 1, 1, 4, 3})) << "two of three corners decide";
  sheet = before;
  turn_mirrored_triangles(sheet, {false, false});
  EXPECT_EQ(sheet.indices, before.indices);
}

}  // namespace
}  // namespace throng::import::testing::facing_test
