#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/import/import.h"
#include "tests/import/test_files.h"

namespace throng::import::testing::parts_test {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A skinned file whose mesh is drawn by a node for each of `extras`, all with the same skin.
json document_with(const std::vector<json>& extras) {
  json document = read_json(data_path("features/data-uri.gltf"));
  json& nodes = document["nodes"];
  std::size_t first = 0;
  while (!nodes[first].contains("skin")) ++first;
  const json model = nodes[first];
  for (std::size_t i = 0; i < extras.size(); ++i) {
    json node = model;
    node["name"] = "body/piece " + std::to_string(i);
    if (!extras[i].is_null()) node["extras"] = extras[i];
    if (i == 0) {
      nodes[first] = node;
      continue;
    }
    document["scenes"][0]["nodes"].push_back(nodes.size());
    nodes.push_back(node);
  }
  return document;
}

json part(const json& said) { return {{"throng_part", said}}; }

anim::ImportedFile imported(const json& document) {
  const TemporaryFolder folder;
  return import_good(folder.write("parts.gltf", document.dump()));
}

TEST(PartsOfAFile, AreApartAndSayWhatTheyFill) {
  const json shirt{
      {"slot", "top"}, {"body", "woman"}, {"covers", {"torso"}}, {"tags", {"warm"}}, {"keeps_out", {"outer"}}};
  const anim::ImportedFile file = imported(document_with({part(shirt), part({{"slot", "top"}})}));
  const anim::Model& model = file.models.front();
  EXPECT_THAT(file.repairs, IsEmpty());
  ASSERT_THAT(model.parts, SizeIs(2));
  EXPECT_EQ(model.parts[0].name, "piece 0") << "without the body before it";
  EXPECT_EQ(model.parts[0].slot, "top");
  EXPECT_EQ(model.parts[0].body, "woman");
  EXPECT_THAT(model.parts[0].covers, ElementsAre("torso"));
  EXPECT_THAT(model.parts[0].keeps_out, ElementsAre("outer"));
  EXPECT_THAT(model.parts[0].tags, ElementsAre("warm"));
  EXPECT_EQ(model.parts[1].body, "");
  EXPECT_THAT(model.parts[1].meshes, SizeIs(1)) << "although it draws the same mesh";
}

TEST(PartsOfAFile, ShowTheFirstOfEachSlotToWhoKnowsNoParts) {
  const json top = part({{"slot", "top"}}), shoes = part({{"slot", "shoes"}});
  const json silhouette = part({{"slot", "silhouette"}});  // stands for all of them, so it is nobody's part
  const anim::ImportedFile file = imported(document_with({top, top, shoes, top, silhouette}));
  EXPECT_THAT(file.models.front().meshes, SizeIs(2));
  EXPECT_THAT(file.models.front().parts, SizeIs(5));
}

TEST(PartsOfAFile, LeaveWhatIsNoPartToBeWornAlways) {
  const anim::ImportedFile file = imported(document_with({json(), part({{"slot", "hat"}})}));
  const anim::Model& model = file.models.front();
  ASSERT_THAT(model.parts, SizeIs(2));
  EXPECT_EQ(model.parts[0].slot, "");
  EXPECT_THAT(model.parts[0].meshes, SizeIs(1));
  EXPECT_EQ(model.parts[1].slot, "hat");
  EXPECT_THAT(model.meshes, SizeIs(2));
}

TEST(PartsOfAFile, MayBeSaidByTheirSlotAlone) {
  const anim::ImportedFile file = imported(document_with({part("hat")}));
  ASSERT_THAT(file.models.front().parts, SizeIs(1));
  EXPECT_EQ(file.models.front().parts[0].slot, "hat");
}

TEST(PartsOfAFile, HaveMeshLodsOfTheirOwn) {
  json document = document_with({part({{"slot", "hat"}}), part({{"slot", "hat"}})});
  json& nodes = document["nodes"];
  json coarser = nodes.back();
  coarser.erase("extras");
  nodes.back()["extras"]["throng_mesh_lods"] = json::array({{{"node", nodes.size()}, {"error", 0.25}}});
  nodes.push_back(coarser);
  const anim::ImportedFile file = imported(document);
  const anim::Model& model = file.models.front();
  EXPECT_THAT(file.repairs, IsEmpty());
  ASSERT_THAT(model.parts, SizeIs(2));
  EXPECT_THAT(model.parts[0].lods, IsEmpty());
  ASSERT_THAT(model.parts[1].lods, SizeIs(1));
  EXPECT_EQ(model.parts[1].lods[0].error, 0.25);
  EXPECT_EQ(model.parts[1].lods[0].meshes[0].palette_entries, model.meshes[0].palette_entries)
      << "in the bones' new order";
}

TEST(PartsOfAFile, WithoutASlotAreRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.write("parts.gltf", document_with({part({{"body", "man"}})}).dump());
  const auto file = import_file(path);
  ASSERT_FALSE(file);
  EXPECT_THAT(file.error().message, HasSubstr("\"slot\" is missing"));
}

}  // namespace
}  // namespace throng::import::testing::parts_test
