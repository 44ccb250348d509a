#include "engine/anim/import/import.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/import/test_files.h"

namespace throng::import::testing::import_test {
namespace {

using nlohmann::json;
using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;

/// The only model of a feature file.
anim::Model feature(const std::string& name) {
  anim::ImportedFile file = import_good(data_path("features/" + name));
  return file.models.empty() ? anim::Model{} : std::move(file.models.front());
}

TEST(Import, TakesTheRigidPathForACharacterWithoutMovingScales) {
  const anim::Skeleton skeleton = feature("plain.glb").skeleton;
  EXPECT_TRUE(skeleton.rigid);
  ASSERT_EQ(skeleton.palette_count(), skeleton.bone_count());
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    EXPECT_EQ(skeleton.palette[static_cast<std::size_t>(bone)].bone, bone);
  }
}

TEST(Import, TakesTheGeneralPathForMovingScalesShearAndMirrors) {
  EXPECT_FALSE(feature("linear-trs.glb").skeleton.rigid);
  EXPECT_FALSE(feature("negative-scale-joint.glb").skeleton.rigid);
  EXPECT_FALSE(feature("matrix-joints.glb").skeleton.rigid);
}

TEST(Import, PutsParentsBeforeChildren) {
  for (const char* name : {"plain.glb", "shuffled-joints.glb", "joints-8-influences.glb", "animated-ancestor.glb"}) {
    const anim::Skeleton skeleton = feature(name).skeleton;
    for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
      EXPECT_LT(skeleton.bones[static_cast<std::size_t>(bone)].parent, bone) << name;
    }
  }
}

TEST(Import, MakesOneModelOfSkinsThatShareJoints) {
  const anim::ImportedFile file = import_good(data_path("features/two-skins-one-skeleton.glb"));
  ASSERT_EQ(file.models.size(), 1U);
  EXPECT_EQ(file.models.front().skins.size(), 2U);
}

TEST(Import, MakesABoneOfAnAnimatedAncestorThatIsNoJoint) {
  const anim::Model model = feature("animated-ancestor.glb");
  EXPECT_GT(model.skeleton.bones.size(), model.skins.front().bones.size());
}

TEST(Import, KeepsTheStrongestFourInfluencesAndSaysSo) {
  const anim::ImportedFile file = import_good(data_path("features/joints-8-influences.glb"));
  EXPECT_THAT(file.repairs, Contains(HasSubstr("the strongest four kept")));
  for (const glm::vec4& weights : file.models.front().meshes.front().weights) {
    EXPECT_NEAR(weights.x + weights.y + weights.z + weights.w, 1.0F, 1e-6F);
    EXPECT_GE(weights.x, weights.y);
    EXPECT_GE(weights.z, weights.w);
  }
}

TEST(Import, BindsAMeshBelowAJointToThatJoint) {
  json document = editable_document();
  const int joint = document["skins"][0]["joints"].back();
  json& nodes = document["nodes"];
  nodes[static_cast<std::size_t>(joint)]["children"].push_back(nodes.size());
  nodes.push_back({{"mesh", 0}, {"translation", {0.0, 1.0, 0.0}}});
  const TemporaryFolder folder;
  const anim::ImportedFile file = import_good(folder.write("attached.gltf", document.dump()));
  ASSERT_EQ(file.models.size(), 1U);
  const anim::Model& model = file.models.front();
  ASSERT_EQ(model.meshes.size(), 2U);
  const auto bone = static_cast<std::uint16_t>(model.skins.front().bones.back());
  EXPECT_THAT(model.meshes.back().palette_entries, Each(glm::u16vec4(bone)));
  EXPECT_THAT(model.meshes.back().weights, Each(glm::vec4(1.0F, 0.0F, 0.0F, 0.0F)));
}

/// The feature with one morph target, which moves each vertex by as much as it is away from the origin.
json document_with_target() {
  json document = editable_document();
  json& primitive = document["meshes"][0]["primitives"][0];
  primitive["targets"] = json::array({{{"POSITION", primitive["attributes"]["POSITION"]}}});
  return document;
}

TEST(Import, AddsMorphTargetsByTheirDefaultWeights) {
  const TemporaryFolder folder;
  json document = document_with_target();
  const anim::SkinnedMesh plain = import_good(folder.write("0.gltf", document.dump())).models.front().meshes.front();
  document["meshes"][0]["weights"] = {0.5};
  const anim::SkinnedMesh half = import_good(folder.write("1.gltf", document.dump())).models.front().meshes.front();
  document["nodes"][6]["weights"] = {1.0};
  const anim::SkinnedMesh whole = import_good(folder.write("2.gltf", document.dump())).models.front().meshes.front();
  const glm::mat4 bind(feature("data-uri.gltf").skins.front().bind_to_model);
  for (std::size_t v = 0; v < plain.positions.size(); ++v) {
    const glm::vec3 own(glm::inverse(bind) * glm::vec4(plain.positions[v], 1.0F));
    EXPECT_LT(glm::distance(half.positions[v], glm::vec3(bind * glm::vec4(1.5F * own, 1.0F))), 1e-5F) << v;
    EXPECT_LT(glm::distance(whole.positions[v], glm::vec3(bind * glm::vec4(2.0F * own, 1.0F))), 1e-5F) << v;
  }
}

TEST(Import, NamesTheFileTheObjectAndWhatToDo) {
  json document = editable_document();
  document["animations"][0]["name"] = "Walk";
  document["animations"][0]["channels"][0]["sampler"] = 77;
  const TemporaryFolder folder;
  const auto path = folder.write("walk.gltf", document.dump());
  EXPECT_EQ(message_of(path),
            path.string() + ": animation 0 \"Walk\", channel 0: there is no sampler 77; export the file again");
}

TEST(Import, KeepsItsErrorOnOneLineWhateverTheFileCallsThings) {
  json document = editable_document();
  document["animations"][0]["name"] = "two\nlines";
  document["animations"][0]["channels"][0]["sampler"] = 77;
  const TemporaryFolder folder;
  EXPECT_THAT(message_of(folder.write("name.gltf", document.dump())), ::testing::Not(HasSubstr("\n")));
}

TEST(Import, CarriesTheChannelsThatAProgramNames) {
  json document = editable_document();
  json& attributes = document["meshes"][0]["primitives"][0]["attributes"];
  attributes["_OWN"] = attributes["POSITION"];
  const TemporaryFolder folder;
  const std::string path = folder.write("channel.gltf", document.dump());
  EXPECT_THAT(import_good(path).models.front().meshes.front().channels, ::testing::IsEmpty());
  const auto file = import_file(path, {.channels = {{"_OWN", 3}, {"_OTHER", 3}}});
  ASSERT_TRUE(file) << file.error().message;
  const anim::SkinnedMesh& mesh = file->models.front().meshes.front();
  EXPECT_THAT(anim::find_channel(mesh, "_OWN"), ::testing::SizeIs(mesh.positions.size() * 3));
  EXPECT_THAT(anim::find_channel(mesh, "_OTHER"), ::testing::IsEmpty());
  const auto wrong = import_file(path, {.channels = {{"_OWN", 2}}});
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().message, HasSubstr("has the wrong type"));
}

TEST(Import, RefusesWhatHasNoSkinOrIsNoFile) {
  json document = editable_document();
  document.erase("skins");
  for (json& node : document["nodes"]) node.erase("skin");
  const TemporaryFolder folder;
  const std::string prop = folder.write("prop.gltf", document.dump());
  EXPECT_THAT(message_of(prop), HasSubstr("holds no skin"));
  const auto skins = import_skins(prop);
  ASSERT_TRUE(skins) << "who asks for every skin there is, gets none";
  EXPECT_TRUE(skins->models.empty());
  EXPECT_FALSE(skins->animations.empty());
  EXPECT_THAT(message_of(folder.write("x.gltf", std::string("{}")).parent_path()), HasSubstr("it is a folder"));
  EXPECT_EQ(message_of("no/such.glb"), "no/such.glb: there is no such file; check the path");
}

}  // namespace
}  // namespace throng::import::testing::import_test
