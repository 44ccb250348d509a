#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/import/import.h"
#include "tests/import/test_files.h"

namespace throng::import::testing::clips_alone_test {
namespace {

using nlohmann::json;

json with_skin() { return read_json(data_path("features/data-uri.gltf")); }

/// The same animations and nodes, as a file without mesh and skin has them.
json without_skin() {
  json document = with_skin();
  for (const char* key : {"skins", "meshes", "materials"}) document.erase(key);
  for (json& node : document["nodes"]) {
    node.erase("skin");
    node.erase("mesh");
  }
  return document;
}

anim::ImportedFile clips_of(const json& document) {
  const TemporaryFolder folder;
  auto file = import_clips(folder.write("clips.gltf", document.dump()).string());
  if (file) return std::move(*file);
  ADD_FAILURE() << file.error().message;
  return {};
}

TEST(ClipsWithoutASkin, PoseTheirNodesAsWithOne) {
  const anim::ImportedFile expected = clips_of(with_skin());
  const anim::ImportedFile file = clips_of(without_skin());
  ASSERT_EQ(file.models.size(), 1U);
  ASSERT_EQ(file.models.front().clips.size(), expected.models.front().clips.size());
  const anim::Skeleton& skeleton = file.models.front().skeleton;
  const anim::Clip& clip = file.models.front().clips.front();
  const double seconds = 0.4 * clip.duration;
  const auto globals = anim::reference_pose(skeleton, &clip, seconds).globals;
  const anim::Model& other = expected.models.front();
  const auto others = anim::reference_pose(other.skeleton, &other.clips.front(), seconds).globals;
  for (std::size_t bone = 0; bone < others.size(); ++bone) {
    const auto same = std::ranges::find(skeleton.bones, other.skeleton.bones[bone].node, &anim::Bone::node);
    ASSERT_NE(same, skeleton.bones.end());
    const glm::dmat4& global = globals[static_cast<std::size_t>(same - skeleton.bones.begin())];
    for (int column = 0; column < 4; ++column) {
      EXPECT_LT(glm::distance(global[column], others[bone][column]), 1e-5);
    }
  }
}

TEST(ClipsWithoutASkin, AreNoCharacter) {
  const TemporaryFolder folder;
  const auto file = import_file(folder.write("clips.gltf", without_skin().dump()).string());
  ASSERT_FALSE(file);
  EXPECT_THAT(file.error().message, ::testing::HasSubstr("holds no skin"));
}

TEST(ClipsWithoutASkin, NeedNodesThatMove) {
  json document = without_skin();
  document.erase("animations");
  EXPECT_TRUE(clips_of(document).models.empty());
}

TEST(ClipsWithoutASkin, AreKnownByTheTextOfTheirFile) {
  const TemporaryFolder folder;
  EXPECT_TRUE(holds_clips_alone(folder.write("clips.gltf", without_skin().dump()).string()));
  EXPECT_FALSE(holds_clips_alone(data_path("features/data-uri.gltf")));
  json still = without_skin();
  still.erase("animations");
  EXPECT_FALSE(holds_clips_alone(folder.write("still.gltf", still.dump()).string()));
  EXPECT_FALSE(holds_clips_alone(folder.write("broken.glb", "glTF").string()));
  EXPECT_FALSE(holds_clips_alone("no-such-file.glb"));
}

}  // namespace
}  // namespace throng::import::testing::clips_alone_test
