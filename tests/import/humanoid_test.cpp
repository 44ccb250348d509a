#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/import/test_files.h"

namespace throng::import::testing::humanoid_test {
namespace {

using nlohmann::json;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

anim::ImportedFile import_with(const json& extensions) {
  const TemporaryFolder folder;
  json document = read_json(data_path("features/data-uri.gltf"));
  document["extensions"] = extensions;
  return import_good(folder.write("avatar.gltf", document.dump()));
}

std::optional<anim::BodyRole> role_of_node(const anim::ImportedFile& file, int node) {
  for (const anim::Bone& bone : file.models.front().skeleton.bones) {
    if (bone.node == node) return bone.role;
  }
  return std::nullopt;
}

int first_joint() { return read_json(data_path("features/data-uri.gltf"))["skins"][0]["joints"][0].get<int>(); }

TEST(HumanoidMap, OfVrm1SaysThePartsAndFacesForward) {
  const anim::ImportedFile file =
      import_with({{"VRMC_vrm", {{"humanoid", {{"humanBones", {{"hips", {{"node", first_joint()}}}}}}}}}});
  EXPECT_EQ(role_of_node(file, first_joint()), anim::BodyRole::hips);
  EXPECT_FALSE(file.models.front().faces_backwards);
  EXPECT_THAT(file.repairs, Not(Contains(HasSubstr("VRM"))));
}

TEST(HumanoidMap, OfVrm0SaysThePartsAndFacesBackwards) {
  const json bones = json::array({{{"bone", "leftUpperLeg"}, {"node", first_joint()}}});
  const anim::ImportedFile file = import_with({{"VRM", {{"humanoid", {{"humanBones", bones}}}}}});
  EXPECT_EQ(role_of_node(file, first_joint()), anim::BodyRole::left_upper_leg);
  EXPECT_TRUE(file.models.front().faces_backwards);
  EXPECT_THAT(file.repairs, IsEmpty());  // nothing is mended: the poses are those of the file
}

TEST(HumanoidMap, LeavesOutAndSaysWhatIsMalformed) {
  for (const json& node : {json(-1), json(99999), json("hips"), json(0.5), json()}) {
    const anim::ImportedFile file =
        import_with({{"VRMC_vrm", {{"humanoid", {{"humanBones", {{"hips", {{"node", node}}}}}}}}}});
    EXPECT_THAT(file.repairs, Contains(HasSubstr("hips; left out"))) << node;
  }
  for (const json& odd : {json(7), json("x"), json::array({1, "a", nullptr}), json::object()}) {
    EXPECT_THAT(import_with({{"VRMC_vrm", odd}}).models, Not(IsEmpty()));
    EXPECT_THAT(import_with({{"VRM", {{"humanoid", odd}}}}).models, Not(IsEmpty()));
    EXPECT_THAT(import_with({{"VRM", {{"humanoid", {{"humanBones", odd}}}}}}).models, Not(IsEmpty()));
  }
}

TEST(HumanoidMap, GivesABoneOnePartAndAPartOneBone) {
  const json bones =
      json::array({{{"bone", "hips"}, {"node", first_joint()}}, {{"bone", "head"}, {"node", first_joint()}}});
  const anim::ImportedFile file = import_with({{"VRM", {{"humanoid", {{"humanBones", bones}}}}}});
  EXPECT_EQ(role_of_node(file, first_joint()), anim::BodyRole::hips);
  EXPECT_THAT(file.repairs, Contains(HasSubstr("taken, for head")));
}

}  // namespace
}  // namespace throng::import::testing::humanoid_test
