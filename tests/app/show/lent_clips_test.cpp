// Files of clips alone, which are lent to the characters that are shown.
#include "app/show/request/lent_clips.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::lent_clips_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string features = THRONG_SOURCE_DIR "/tests/data/features/";

class ClipsOfAFile : public test::TemporaryFolder {
 protected:
  /// Writes the clip of data-uri.gltf without its mesh and skin.
  std::string clips_alone() const {
    std::ifstream stream(features + "data-uri.gltf");
    nlohmann::json file = nlohmann::json::parse(stream);
    for (const char* const key : {"meshes", "skins", "materials"}) file.erase(key);
    for (nlohmann::json& node : file["nodes"]) {
      node.erase("mesh");
      node.erase("skin");
    }
    const std::filesystem::path path = folder_ / "moves.gltf";
    std::ofstream(path) << file.dump();
    return path.string();
  }
  static std::unique_ptr<Show> show_of(const std::string& models) {
    return test::show_of(test::demo("--agents 8 --cast " + models));
  }
  static Result<std::optional<LentClips>> lent(const std::string& file, const Show& show) {
    return lent_clips({&file, 1}, show.stage().people());
  }
};

TEST_F(ClipsOfAFile, AreLentToAllWhoseBonesTheyFit) {
  const auto show = show_of(features + "no-animation.glb," + features + "no-names.glb");
  const std::string clips = clips_alone();
  const auto lent_to = lent(clips, *show);
  ASSERT_TRUE(lent_to) << lent_to.error().message;
  ASSERT_TRUE(*lent_to);
  EXPECT_THAT((*lent_to)->words, HasSubstr("The clips of moves.gltf are lent to "));
  EXPECT_THAT((*lent_to)->words, HasSubstr("no-animation"));
  test::ask(*show, (*lent_to)->request);
  EXPECT_THAT(show->stage().people()[0].clip_files, ElementsAre(clips));
  EXPECT_FALSE(show->stage().people()[0].clip_names.empty());
  EXPECT_THAT(show->stage().people()[1].clip_files, IsEmpty()) << "it has none of their bones";
}

TEST_F(ClipsOfAFile, AreRefusedWhereNoCharacterHasTheirBonesOrAllPlayThem) {
  const std::string clips = clips_alone();
  const auto to_others = lent(clips, *show_of(features + "no-names.glb"));
  ASSERT_FALSE(to_others);
  EXPECT_THAT(to_others.error().message, HasSubstr("moves.gltf: no bone of"));
  const auto show = show_of(features + "no-animation.glb");
  const auto once = lent(clips, *show);
  ASSERT_TRUE(once && *once);
  test::ask(*show, (*once)->request);
  const auto twice = lent(clips, *show);
  ASSERT_FALSE(twice);
  EXPECT_THAT(twice.error().message, HasSubstr("play its clips already"));
}

TEST_F(ClipsOfAFile, ThatHasAMeshTooAreACharacterOfTheirOwn) {
  const auto show = show_of(features + "no-animation.glb");
  for (const std::string& file : {features + "plain.glb", std::string(THRONG_SOURCE_DIR "/README.md")}) {
    const auto lent_to = lent(file, *show);
    EXPECT_TRUE(lent_to && !*lent_to) << file;
  }
}

}  // namespace
}  // namespace throng::app::lent_clips_test
