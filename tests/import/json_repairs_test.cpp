#include "engine/anim/import/json_repairs.h"

#include <cstddef>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/import/test_files.h"

// Import mends and reports a mistake that means one thing. It refuses a mistake that could mean anything.

namespace throng::import::testing::json_repairs_test {
namespace {

using nlohmann::json;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Document : public ::testing::Test {
 protected:
  anim::ImportedFile imported() const { return import_good(written()); }
  std::string refusal(bool strict = false) const { return message_of(written(), strict); }
  std::filesystem::path written() const { return folder_.write("model.gltf", document_.dump()); }

  json document_ = editable_document();

 private:
  TemporaryFolder folder_;
};

TEST_F(Document, SaysThatARotationIsNoRotation) {
  document_["nodes"][0]["rotation"] = {0, 0, 0, 2};
  const anim::ImportedFile file = imported();
  EXPECT_THAT(file.repairs, ElementsAre(HasSubstr("node 0 \"armature\": its rotation has length 2, normalised")));
  EXPECT_THAT(refusal(true), HasSubstr("its rotation has length 2, normalised; strict reading refuses that"));
}

TEST_F(Document, SaysThatASceneNamesAChild) {
  document_["scenes"][0]["nodes"] = {1, 6};
  EXPECT_THAT(imported().repairs, ElementsAre(HasSubstr("scene 0: names node 1 \"joint0\", a child of node 0")));
}

TEST_F(Document, RefusesWhatNeedsALaterVersion) {
  document_["asset"]["version"] = "2.1";
  document_["asset"]["minVersion"] = "2.0";
  EXPECT_EQ(refusal(), "");
  document_["asset"]["minVersion"] = "2.1";
  EXPECT_THAT(refusal(), HasSubstr("it needs glTF 2.1, and 2.0 is supported"));
}

TEST_F(Document, RefusesANumberBeyondAFloat) {
  document_["nodes"][2]["translation"] = {0, 1e39, 0};
  EXPECT_THAT(refusal(), HasSubstr("node 2 \"joint1\": \"translation\" is 1e+39, more than a float holds"));
}

TEST_F(Document, RefusesNumbersWhoseProductIsBeyondAFloat) {
  document_["nodes"][1]["scale"] = {1e30, 1e30, 1e30};
  document_["nodes"][3]["translation"] = {0, 1e30, 0};
  EXPECT_THAT(refusal(), HasSubstr("leads further than numbers reach"));
}

TEST_F(Document, TakesBoundsInDouble) {
  document_["accessors"][0]["max"] = {1.7e308, 1.7e308, 1.7e308};
  EXPECT_EQ(refusal(), "");
}

TEST_F(Document, TakesNamesAsPlainText) {
  document_["skins"][0]["name"] = "rig\x1B[1A";
  document_["animations"][0]["name"] = "two\nlines\u202E";
  document_["nodes"][1]["rotation"] = {0, 0, 0, 3};
  document_["nodes"][1]["name"] = "\x07";
  const anim::ImportedFile file = imported();
  EXPECT_EQ(file.models.front().skeleton.name, "rig\uFFFD[1A");
  EXPECT_EQ(file.models.front().clips.front().name, "two lines\uFFFD");
  EXPECT_THAT(file.animations, ElementsAre("two lines\uFFFD"));
  EXPECT_THAT(file.repairs, ElementsAre(HasSubstr("node 1 \"\uFFFD\"")));
}

TEST_F(Document, TakesNamesThatAreNoUtf8) {
  document_["skins"][0]["name"] = "Mueller";
  std::string text = document_.dump();
  text.replace(text.find("ueller"), 2, "\xFC");
  const TemporaryFolder folder;
  const anim::ImportedFile file = import_good(folder.write("latin.gltf", text));
  EXPECT_EQ(file.models.front().skeleton.name, "M\uFFFDller");
  EXPECT_THAT(file.repairs, ElementsAre(HasSubstr("no UTF-8")));
}

TEST_F(Document, PlaysOrdinaryChannelsBesideThoseOfAnExtension) {
  document_["extensionsUsed"] = {"KHR_animation_pointer"};
  json& channel = document_["animations"][0]["channels"][1];
  channel["target"] = {{"path", "pointer"},
                       {"extensions", {{"KHR_animation_pointer", {{"pointer", "/nodes/2/rotation"}}}}}};
  const anim::ImportedFile file = imported();
  EXPECT_THAT(file.repairs, ElementsAre(HasSubstr("animation 0 \"wave\", channel 1: animates \"pointer\", which")));
  EXPECT_EQ(file.models.front().clips.front().tracks.size(), 4U);
}

TEST_F(Document, KeepsAnAnimationThatHasNothingButUnknownChannels) {
  json& animation = document_["animations"][0];
  for (json& channel : animation["channels"]) {
    channel["target"] = {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", json::object()}}}};
  }
  EXPECT_THAT(imported().animations, ElementsAre("wave"));
}

TEST_F(Document, LeavesOutInterpolationsAndAlphaModesOfExtensions) {
  document_["extensionsUsed"] = {"EXT_future"};
  document_["animations"][0]["samplers"][2]["interpolation"] = "BEZIER";
  document_["materials"] = {{{"name", "hair"}, {"alphaMode", "DITHER"}}};
  const anim::ImportedFile file = imported();
  EXPECT_THAT(file.repairs, ElementsAre(HasSubstr("channel 2: an extension adds its interpolation, left out"),
                                        HasSubstr("material 0 \"hair\": an extension adds its alpha mode \"DITHER\"")));
  EXPECT_EQ(file.models.front().clips.front().tracks.size(), 4U);
}

TEST_F(Document, RefusesUnknownValuesThatNoExtensionExplains) {
  document_["animations"][0]["channels"][1]["target"]["path"] = "rotate";
  EXPECT_THAT(refusal(), HasSubstr("\"path\" is none of translation|rotation|scale|weights"));
}

TEST_F(Document, TakesRequiredExtensionsThatChangeNoShapeAndSaysSo) {
  for (const char* name : {"KHR_materials_clearcoat", "KHR_materials_transmission", "ADOBE_materials_thin_transparency",
                           "KHR_lights_punctual", "KHR_xmp_json_ld", "VRMC_springBone", "KHR_animation_pointer"}) {
    document_["extensionsUsed"] = {name};
    document_["extensionsRequired"] = {name};
    EXPECT_THAT(imported().repairs, ElementsAre(HasSubstr(std::string("requires the extension ") + name)));
  }
  for (const char* name :
       {"KHR_mesh_quantization", "KHR_texture_transform", "KHR_draco_mesh_compression", "VRM", "VRMC_vrm"}) {
    document_["extensionsRequired"] = {name};
    EXPECT_THAT(imported().repairs, IsEmpty()) << name;
  }
  document_["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  EXPECT_THAT(refusal(), HasSubstr("it requires the extension EXT_mesh_gpu_instancing, which is not supported"));
}

TEST_F(Document, SaysThatSparseIndicesDoNotAscend) {
  std::string zeros;
  for (int i = 0; i < 24; ++i) zeros += "%00";
  document_["buffers"].push_back({{"byteLength", 32}, {"uri", "data:,%02%00%00%00%01%00%00%00" + zeros}});
  const std::size_t view = document_["bufferViews"].size();
  document_["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 8}});
  document_["bufferViews"].push_back({{"buffer", 1}, {"byteOffset", 8}, {"byteLength", 24}});
  document_["accessors"][0]["sparse"] = {{"count", 2},
                                         {"indices", {{"bufferView", view}, {"componentType", 5125}}},
                                         {"values", {{"bufferView", view + 1}}}};
  EXPECT_THAT(imported().repairs, ElementsAre(HasSubstr("accessor 0: 1 of its sparse indices do not ascend")));
}

TEST_F(Document, TakesWeightsThatAreNoNumbersForNone) {
  const TemporaryFolder folder;
  std::vector<char> bytes = editable_buffer();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(bytes.data() + 704, &nan, sizeof nan);  // the first weight of the first vertex
  folder.write("m.bin", bytes);
  document_["buffers"][0]["uri"] = "m.bin";
  const anim::ImportedFile file = import_good(folder.write("model.gltf", document_.dump()));
  EXPECT_THAT(file.repairs, Contains(HasSubstr("1 weights are not finite, taken as 0")));
  for (const glm::vec4& weights : file.models.front().meshes.front().weights) {
    EXPECT_NEAR(weights.x + weights.y + weights.z + weights.w, 1.0F, 1e-6F);
  }
}

}  // namespace
}  // namespace throng::import::testing::json_repairs_test
