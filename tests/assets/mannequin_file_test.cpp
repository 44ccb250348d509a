#include <algorithm>

#include <gtest/gtest.h>

#include "assets/mannequin/glb.h"
#include "tests/assets/character_file.h"
#include "tests/assets/rounded_file.h"

namespace throng::test::mannequin_file_test {
namespace {

TEST(MannequinFile, IsWhatItsProgramWritesToWithinOneRoundingStep) {
  expect_rounded_alike(mannequin::make_mannequin(), "mannequin.glb");
}

TEST(MannequinFile, HasOneSkinOfSixtyTwoJointsUnderOneRootAtTheGround) {
  const CharacterFile file = CharacterFile::committed();
  ASSERT_EQ(file.json()["skins"].size(), 1U);
  const std::vector<std::string> names = file.joint_names();
  ASSERT_EQ(names.size(), 62U);
  EXPECT_EQ(names[0], "root");
  EXPECT_FALSE(file.json()["nodes"][0].contains("translation")) << "root is at the origin";
  EXPECT_EQ(file.json()["nodes"][0]["children"], nlohmann::json::array({1}));
  EXPECT_EQ(names[1], "hips");
  for (const char* name :
       {"spine", "chest", "upper_chest", "neck", "head", "shoulder.L", "upper_arm.R", "forearm.L", "hand.R",
        "thumb.3.L", "index.1.R", "middle.2.L", "ring.3.R", "little.3.L", "thigh.L", "shin.R", "foot.L", "toe.R"}) {
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  }
}

TEST(MannequinFile, BindsEveryJointByATranslationToItsRest) {
  const CharacterFile file = CharacterFile::committed();
  const std::vector<double> binds = file.values(file.json()["skins"][0]["inverseBindMatrices"]);
  ASSERT_EQ(binds.size(), 62U * 16);
  const Playback idle(file, "idle");
  for (std::size_t j = 0; j < 62; ++j) {
    for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(binds[16 * j + i], i % 5 == 0 ? 1.0 : 0.0);
    const glm::dvec3 rest = idle.rest(j);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(binds[16 * j + 12 + static_cast<std::size_t>(axis)], -rest[axis], 1e-6) << file.joint_names()[j];
    }
  }
}

TEST(MannequinFile, LeavesOutTracksThatDoNotMove) {
  const CharacterFile file = CharacterFile::committed();
  for (const auto& animation : file.json()["animations"]) {
    for (const auto& channel : animation["channels"]) {
      const auto& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
      const std::vector<double> keys = file.values(sampler["output"]);
      const std::size_t width = channel["target"]["path"] == "rotation" ? 4 : 3;
      const bool moves = !std::equal(keys.begin() + static_cast<std::ptrdiff_t>(width), keys.end(), keys.begin());
      EXPECT_TRUE(moves) << animation["name"] << " of "
                         << file.json()["nodes"][channel["target"]["node"].get<std::size_t>()]["name"];
    }
  }
}

}  // namespace
}  // namespace throng::test::mannequin_file_test
