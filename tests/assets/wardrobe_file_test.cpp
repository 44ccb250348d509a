#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "assets/wardrobe/finish.h"
#include "assets/wardrobe/glb.h"
#include "tests/assets/character_file.h"

namespace throng::test::wardrobe_file_test {
namespace {

std::vector<std::byte> committed_wardrobe() {
  return CharacterFile::read(std::filesystem::path(THRONG_SOURCE_DIR) / "assets" / "wardrobe.glb");
}

/// Where a library's sines differ in the last bit, a number may be rounded the other way: a few bytes differ.
TEST(WardrobeFile, IsWhatItsProgramWrites) {
  const std::vector<std::byte> made = wardrobe::make_wardrobe();
  const std::vector<std::byte> committed = committed_wardrobe();
  ASSERT_EQ(made.size(), committed.size()) << "regenerate assets/wardrobe.glb";
  std::size_t different = 0;
  for (std::size_t i = 0; i < made.size(); ++i) different += made[i] != committed[i] ? 1U : 0U;
  EXPECT_LT(different, made.size() / 1000) << "regenerate assets/wardrobe.glb";
}

TEST(WardrobeFile, HoldsExactlyThePiecesOfEachBody) {
  const CharacterFile file(committed_wardrobe());
  std::map<std::string, std::multiset<std::string>> pieces;
  for (const auto& node : file.json()["nodes"]) {
    if (!node.contains("extras") || !node["extras"].contains("throng_part")) continue;
    const auto& part = node["extras"]["throng_part"];
    const std::string slot = part["slot"];
    const std::string body = part["body"];
    EXPECT_TRUE(node["name"].get<std::string>().starts_with(body + "/"));
    if (node["name"] == body + "/" + slot) pieces[body].insert(slot);
  }
  const std::multiset<std::string> all{"head", "torso", "upper_arms", "forearms", "hands", "thighs", "shins", "feet"};
  EXPECT_EQ(pieces, (std::map<std::string, std::multiset<std::string>>{{"man", all}, {"woman", all}, {"child", all}}));
}

TEST(WardrobeFile, KeepsToTheBoundsOfItsLevels) {
  const CharacterFile file(committed_wardrobe());
  std::size_t parts = 0;
  for (const auto& node : file.json()["nodes"]) {
    if (!node.contains("extras") || node["extras"]["throng_part"]["slot"] == "silhouette") continue;
    ++parts;
    const auto& levels = node["extras"]["throng_mesh_lods"];
    ASSERT_EQ(levels.size(), wardrobe::level_bounds.size()) << node["name"];
    for (std::size_t level = 0; level < levels.size(); ++level) {
      EXPECT_LE(levels[level]["error"].get<double>(), wardrobe::level_bounds.at(level) + 1e-4) << node["name"];
    }
  }
  EXPECT_GT(parts, 24U);
}

TEST(WardrobeFile, HasASilhouetteForEachKindOfOutfit) {
  const CharacterFile file(committed_wardrobe());
  std::set<std::string> names;
  for (const auto& node : file.json()["nodes"]) names.insert(node["name"].get<std::string>());
  for (const std::string body : {"man", "woman", "child"}) {
    for (const std::string bottom : {"trousers", "shorts", "skirt", "long", "coat"}) {
      for (const std::string hair : {"short", "long", "hat"}) {
        for (const std::string level : {"", ".1", ".2"}) {
          const std::string name = body + "/silhouette/" + bottom + "/" + hair + level;
          EXPECT_TRUE(names.contains(name)) << name;
        }
      }
    }
  }
}

}  // namespace
}  // namespace throng::test::wardrobe_file_test
