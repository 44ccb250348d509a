#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/import/import.h"
#include "tests/import/test_files.h"

namespace throng::import::testing::mesh_lods_test {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A file whose skinned node names a second one, outside of the scene, as its mesh LOD.
json document_with_lod() {
  json document = read_json(data_path("features/data-uri.gltf"));
  const std::size_t extra = document["nodes"].size();
  json lod;
  for (json& node : document["nodes"]) {
    if (!node.contains("skin")) continue;
    document["meshes"].push_back(document["meshes"][node["mesh"].get<std::size_t>()]);
    lod = {{"name", "lod"}, {"mesh", document["meshes"].size() - 1}, {"skin", node["skin"]}};
    node["extras"] = {{"throng_mesh_lods", json::array({{{"node", extra}, {"error", 0.25}}})}};
  }
  document["nodes"].push_back(lod);
  return document;
}

anim::ImportedFile imported(const json& document) {
  const TemporaryFolder folder;
  return import_good(folder.write("lod.gltf", document.dump()));
}

TEST(MeshLodsOfAFile, AreReadBesideTheMeshTheyStandInFor) {
  const anim::ImportedFile file = imported(document_with_lod());
  const anim::Model& model = file.models.front();
  EXPECT_THAT(file.repairs, IsEmpty());
  EXPECT_EQ(model.meshes.size(), 1U);
  ASSERT_EQ(model.mesh_lods.size(), 1U);
  EXPECT_EQ(model.mesh_lods[0].error, 0.25);
  ASSERT_EQ(model.mesh_lods[0].meshes.size(), 1U);
  EXPECT_EQ(model.mesh_lods[0].meshes[0].palette_entries, model.meshes[0].palette_entries) << "in the bones' new order";
}

TEST(MeshLodsOfAFile, AreLeftOutWhereNotEveryMeshHasThem) {
  json document = document_with_lod();
  json second = document["nodes"].back();
  document["meshes"].push_back(document["meshes"][0]);
  second["mesh"] = document["meshes"].size() - 1;
  document["nodes"].push_back(second);
  document["scenes"][0]["nodes"].push_back(document["nodes"].size() - 1);
  const anim::ImportedFile file = imported(document);
  EXPECT_THAT(file.models.front().mesh_lods, IsEmpty());
  EXPECT_THAT(file.repairs, ElementsAre(HasSubstr("mesh LODs left out, because not every mesh")));
}

TEST(MeshLodsOfAFile, OfAnotherSkinAreRefused) {
  json document = document_with_lod();
  document["nodes"].back().erase("skin");
  const TemporaryFolder folder;
  const auto file = import_file(folder.write("lod.gltf", document.dump()).string());
  ASSERT_FALSE(file);
  EXPECT_THAT(file.error().message, HasSubstr("draws no mesh of the same skin"));
}

TEST(MeshLodsOfAFile, AreCheckedAsAllElseIs) {
  for (const json& broken : {json{{"node", 999}, {"error", 0.1}}, json{{"error", 0.1}}, json{{"node", 0}}, json(7)}) {
    json document = document_with_lod();
    for (json& node : document["nodes"]) {
      if (node.contains("extras")) node["extras"]["throng_mesh_lods"] = json::array({broken});
    }
    const TemporaryFolder folder;
    EXPECT_FALSE(import_file(folder.write("lod.gltf", document.dump()).string())) << broken;
  }
}

}  // namespace
}  // namespace throng::import::testing::mesh_lods_test
