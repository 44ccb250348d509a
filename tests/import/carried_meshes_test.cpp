#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/import/import.h"
#include "tests/import/test_files.h"

namespace throng::import::testing::carried_meshes_test {
namespace {

using nlohmann::json;
using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A pole 2 units tall, on five joints below the node "armature", with one clip.
json pole() { return read_json(data_path("features/data-uri.gltf")); }

/// Adds a node that draws the pole's mesh without its skin, a root of the scene.
json& add_rigid(json& document, const json& node) {
  json& nodes = document["nodes"];
  document["scenes"][0]["nodes"].push_back(nodes.size());
  nodes.push_back(node);
  nodes.back()["mesh"] = 0;
  return nodes.back();
}

anim::ImportedFile imported(const json& document) {
  const TemporaryFolder folder;
  return import_good(folder.write("model.gltf", document.dump()));
}

/// Returns the place of a mesh's first vertex in a pose; the pole's is at (-0.1, 0, -0.1) or so in its own space.
glm::dvec3 first_vertex(const anim::Model& model, const anim::SkinnedMesh& mesh, const anim::Clip* clip,
                        double seconds) {
  const anim::ReferencePose pose = anim::reference_pose(model.skeleton, clip, seconds);
  return glm::dvec3(pose.palette[mesh.palette_entries.front().x] * glm::dvec4(glm::dvec3(mesh.positions.front()), 1.0));
}

glm::dvec3 own_place(const json& document) {
  json alone = document;
  add_rigid(alone, {{"name", "own"}});
  const anim::ImportedFile file = imported(alone);
  return first_vertex(file.models.front(), file.models.front().meshes.back(), nullptr, 0.0);
}

TEST(CarriedMesh, BesideTheJointsStandsWhereItsNodeIs) {
  json document = pole();
  add_rigid(document, {{"name", "turret"}, {"translation", {0.0, 0.25, 0.0}}});
  const anim::ImportedFile file = imported(document);
  const anim::Model& model = file.models.front();
  ASSERT_EQ(model.meshes.size(), 2U);
  EXPECT_TRUE(model.skeleton.rigid);
  const glm::dvec3 expected = own_place(pole()) + glm::dvec3(0.0, 0.25, 0.0);
  for (const double seconds : {0.0, 0.4, 1.0}) {
    const glm::dvec3 place = first_vertex(model, model.meshes.back(), &model.clips.front(), seconds);
    EXPECT_LT(glm::distance(place, expected), 1e-6) << seconds;
  }
  EXPECT_THAT(file.repairs, IsEmpty());
}

TEST(CarriedMesh, BelowTheArmatureStandsWhereTheArmatureCarriesIt) {
  json document = pole();
  document["nodes"][0]["translation"] = {0.0, 0.5, 0.0};
  add_rigid(document, {{"name", "hat"}});
  document["scenes"][0]["nodes"].erase(2);
  document["nodes"][0]["children"].push_back(document["nodes"].size() - 1);
  const anim::ImportedFile file = imported(document);
  const anim::Model& model = file.models.front();
  ASSERT_EQ(model.meshes.size(), 2U);
  const glm::dvec3 expected = own_place(pole()) + glm::dvec3(0.0, 0.5, 0.0);
  EXPECT_LT(glm::distance(first_vertex(model, model.meshes.back(), nullptr, 0.0), expected), 1e-6);
}

TEST(CarriedMesh, MovesWithTheAnimationOfItsOwnNode) {
  json document = pole();
  add_rigid(document, {{"name", "gun"}});
  json& animation = document["animations"][0];
  animation["channels"].push_back(
      {{"sampler", 0}, {"target", {{"node", document["nodes"].size() - 1}, {"path", "rotation"}}}});
  const anim::ImportedFile file = imported(document);
  const anim::Model& model = file.models.front();
  ASSERT_EQ(model.meshes.size(), 2U);
  const anim::SkinnedMesh& gun = model.meshes.back();
  const glm::dvec3 before = first_vertex(model, gun, &model.clips.front(), 0.0);
  const glm::dvec3 later = first_vertex(model, gun, &model.clips.front(), 1.0);
  EXPECT_GT(glm::distance(before, later), 1e-3);
  const anim::Skeleton& skeleton = model.skeleton;
  const int bone = skeleton.palette[gun.palette_entries.front().x].bone;
  EXPECT_EQ(skeleton.bones[static_cast<std::size_t>(bone)].name, "gun");
}

TEST(CarriedMesh, ThatIsSceneryIsLeftOutAndNamed) {
  for (const json& node : {json{{"name", "Ground"}, {"scale", {50.0, 0.01, 50.0}}},
                           json{{"name", "Tree"}, {"translation", {12.0, 0.0, 0.0}}}}) {
    json document = pole();
    add_rigid(document, node);
    const anim::ImportedFile file = imported(document);
    EXPECT_EQ(file.models.front().meshes.size(), 1U);
    EXPECT_THAT(file.repairs, Contains(HasSubstr("left out as scenery")));
    EXPECT_THAT(file.repairs, Contains(HasSubstr(node["name"].get<std::string>())));
  }
}

TEST(CarriedMesh, GoesWithTheNearestOfSeveralSkeletons) {
  json document = pole();
  json& nodes = document["nodes"];
  const int copy = static_cast<int>(nodes.size());
  for (int i = 0; i < 7; ++i) {
    json node = nodes[static_cast<std::size_t>(i)];
    if (node.contains("children")) node["children"] = {i + 1 + copy};
    if (node.contains("skin")) node["skin"] = 1;
    nodes.push_back(node);
  }
  nodes[static_cast<std::size_t>(copy)]["translation"] = {10.0, 0.0, 0.0};
  document["scenes"][0]["nodes"] = {0, 6, copy, copy + 6};
  json skin = document["skins"][0];
  for (json& joint : skin["joints"]) joint = joint.get<int>() + copy;
  document["skins"].push_back(skin);
  add_rigid(document, {{"name", "hat"}, {"translation", {10.0, 0.2, 0.0}}});
  const anim::ImportedFile file = imported(document);
  ASSERT_EQ(file.models.size(), 2U);
  for (const anim::Model& model : file.models) {
    EXPECT_EQ(model.meshes.size(), model.skins.front().skin == 1 ? 2U : 1U);
  }
}

TEST(HiddenNode, IsNotDrawnAndNeitherIsWhatHangsBelowIt) {
  json document = pole();
  add_rigid(document, {{"name", "helper"}, {"translation", {0.0, 0.25, 0.0}}});
  const json hidden = {{"KHR_node_visibility", {{"visible", false}}}};
  document["nodes"][7]["extensions"] = hidden;
  document["extensionsUsed"] = {"KHR_node_visibility"};
  document["extensionsRequired"] = {"KHR_node_visibility"};
  anim::ImportedFile file = imported(document);
  EXPECT_EQ(file.models.front().meshes.size(), 1U);
  EXPECT_THAT(file.repairs, Contains(HasSubstr("node 7 \"helper\": its mesh is hidden by KHR_node_visibility")));

  document["nodes"][7].erase("extensions");
  document["nodes"].push_back({{"name", "group"}, {"children", {7}}, {"extensions", hidden}});
  document["scenes"][0]["nodes"] = {0, 6, 8};
  file = imported(document);
  EXPECT_EQ(file.models.front().meshes.size(), 1U);

  document["nodes"][8]["extensions"]["KHR_node_visibility"]["visible"] = true;
  EXPECT_EQ(imported(document).models.front().meshes.size(), 2U);
}

}  // namespace
}  // namespace throng::import::testing::carried_meshes_test
