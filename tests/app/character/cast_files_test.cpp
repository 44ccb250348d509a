// Sets of files: folders, shares, clips that lie beside characters, and what cannot be shown.

#include "app/character/cast_files.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/temporary_folder.h"

namespace throng::app::cast_files_test {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const fs::path features = fs::path(THRONG_SOURCE_DIR) / "tests/data/features";

std::string refusal(const Result<LoadedCast>& cast) { return cast ? "(taken)" : cast.error().message; }

class CastFiles : public test::TemporaryFolder {
 protected:
  fs::path put(const std::string& feature, const std::string& name) const {
    fs::create_directories((folder_ / name).parent_path());
    fs::copy_file(features / feature, folder_ / name);
    return folder_ / name;
  }
  void put_text(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

  /// Puts a file with the clip of data-uri.gltf, without its mesh and skin.
  void put_clips(const std::string& name) const {
    std::ifstream stream(features / "data-uri.gltf");
    nlohmann::json file = nlohmann::json::parse(stream);
    file.erase("meshes");
    file.erase("skins");
    file.erase("materials");
    for (nlohmann::json& node : file["nodes"]) {
      node.erase("mesh");
      node.erase("skin");
    }
    put_text(name, file.dump());
  }

  /// Names without the folder.
  std::vector<std::string> names(const LoadedCast& cast) const {
    std::vector<std::string> names;
    for (const CharacterSource& character : cast.characters) {
      names.push_back(fs::path(character.file).lexically_relative(folder_).string());
    }
    return names;
  }
  static std::vector<double> shares(const LoadedCast& cast) {
    std::vector<double> shares;
    for (const CharacterSource& character : cast.characters) shares.push_back(character.roles.share);
    return shares;
  }
};

TEST_F(CastFiles, OfAFolderAreItsModelsByName) {
  for (const char* const name : {"c.glb", "a.GLB", "b.gltf", ".hidden.glb", "below/d.glb"}) {
    put(std::string(name) == "b.gltf" ? "data-uri.gltf" : "plain.glb", name);
  }
  put_text("readme.txt", "no model");
  const CastEntry folder{.file = folder_.string()};
  const auto cast = load_cast({&folder, 1});
  ASSERT_TRUE(cast) << cast.error().message;
  EXPECT_THAT(names(*cast), ElementsAre("a.GLB", "b.gltf", "c.glb"));
  EXPECT_THAT(shares(*cast), ElementsAre(1.0, 1.0, 1.0));
  EXPECT_THAT(cast->left_out, IsEmpty());
}

TEST_F(CastFiles, ShareTheShareOfTheirEntryEvenly) {
  put("plain.glb", "people/a.glb");
  put("plain.glb", "people/b.glb");
  const fs::path boss = put("two-skins-one-skeleton.glb", "boss.glb");
  const std::vector<CastEntry> entries{{.file = (folder_ / "people").string(), .share = 3.0},
                                       {.file = boss.string() + "#all", .share = 2.0},
                                       {.file = boss.string()}};
  const auto cast = load_cast(entries);
  ASSERT_TRUE(cast) << cast.error().message;
  const auto of_boss = static_cast<double>(cast->characters.size() - 3);
  EXPECT_EQ(cast->characters[0].roles.share, 1.5);
  EXPECT_EQ(cast->characters[1].roles.share, 1.5);
  EXPECT_EQ(cast->characters[2].roles.share, 2.0 / of_boss);
  EXPECT_EQ(cast->characters.back().roles.share, 1.0);
}

TEST_F(CastFiles, ThatHoldClipsAloneGiveThemToTheOthersOfTheirFolder) {
  put("no-animation.glb", "people/a.glb");
  put_clips("people/moves.gltf");
  const fs::path other = put("no-animation.glb", "other.glb");
  const std::vector<CastEntry> entries{{.file = (folder_ / "people").string()}, {.file = other.string()}};
  const auto cast = load_cast(entries);
  ASSERT_TRUE(cast) << cast.error().message;
  EXPECT_THAT(names(*cast), ElementsAre("people/a.glb", "other.glb"));
  EXPECT_THAT(cast->characters[0].clip_files, ElementsAre((folder_ / "people/moves.gltf").string()));
  EXPECT_FALSE(cast->characters[0].model.clips.empty());
  EXPECT_THAT(cast->characters[1].clip_files, IsEmpty());
  const std::vector<std::string> named{(folder_ / "people/moves.gltf").string()};
  const auto once = load_cast({entries.data(), 1}, {.clips_from = named});
  ASSERT_TRUE(once) << once.error().message;
  EXPECT_EQ(once->characters[0].clip_files, named) << "once, though it is named too";
}

TEST_F(CastFiles, ThatHoldClipsOfOtherBonesLeaveAsTheyAreWhoHasNone) {
  put("no-names.glb", "a.glb");
  put_clips("moves.gltf");
  const CastEntry folder{.file = folder_.string()};
  const auto cast = load_cast({&folder, 1});
  ASSERT_TRUE(cast) << cast.error().message;
  EXPECT_THAT(cast->characters[0].clip_files, IsEmpty());
  EXPECT_THAT(cast->characters[0].notes, Contains(HasSubstr("plays none of the clips of")));
}

TEST_F(CastFiles, ThatWereDroppedTogetherShareTheirClips) {
  put("no-animation.glb", "people/a.glb");
  const fs::path b = put("no-animation.glb", "b.glb");
  put_clips("moves.gltf");
  const std::vector<std::string> files{(folder_ / "moves.gltf").string(), (folder_ / "people").string(), b.string()};
  const auto cast = load_dropped(files);
  ASSERT_TRUE(cast) << cast.error().message;
  EXPECT_THAT(names(*cast), ElementsAre("people/a.glb", "b.glb"));
  for (const CharacterSource& each : cast->characters) EXPECT_THAT(each.clip_files, ElementsAre(files[0]));
}

TEST_F(CastFiles, OfAFolderThatCannotBeReadAreLeftOutAndNamed) {
  put("plain.glb", "a.glb");
  put_text("broken.glb", "no glTF");
  const CastEntry folder{.file = folder_.string()};
  const auto cast = load_cast({&folder, 1});
  ASSERT_TRUE(cast) << cast.error().message;
  EXPECT_THAT(names(*cast), ElementsAre("a.glb"));
  ASSERT_EQ(cast->left_out.size(), 1U);
  EXPECT_THAT(cast->left_out[0], HasSubstr("broken.glb"));
  EXPECT_THAT(cast->left_out[0], HasSubstr("; it is left out."));
  EXPECT_THAT(refusal(load_cast({&folder, 1}, {.import = {.strict = true}})), HasSubstr("broken.glb"));
}

TEST_F(CastFiles, ThatAreLeftOutAreAllNamedAndTheFirstExplained) {
  put("plain.glb", "a.glb");
  for (int i = 0; i < 9; ++i) put_text("broken" + std::to_string(i) + ".glb", "no glTF");
  const CastEntry folder{.file = folder_.string()};
  const auto cast = load_cast({&folder, 1});
  ASSERT_TRUE(cast) << cast.error().message;
  ASSERT_EQ(cast->left_out.size(), 7U);
  EXPECT_EQ(cast->left_out.back(), "Left out as well: broken6.glb, broken7.glb and broken8.glb.");
}

TEST_F(CastFiles, ThatWereNamedAreRefusedWhereTheyCannotBeRead) {
  const fs::path good = put("plain.glb", "a.glb");
  put_text("broken.glb", "no glTF");
  const std::vector<CastEntry> entries{{.file = good.string()}, {.file = (folder_ / "broken.glb").string()}};
  EXPECT_THAT(refusal(load_cast(entries)), HasSubstr("broken.glb"));
  const std::vector<std::string> dropped{(folder_ / "broken.glb").string()};
  EXPECT_THAT(refusal(load_dropped(dropped)), Not(HasSubstr("left out")));
}

TEST_F(CastFiles, OfFoldersWithNobodyAreRefused) {
  const CastEntry folder{.file = folder_.string()};
  EXPECT_EQ(refusal(load_cast({&folder, 1})),
            folder_.string() +
                ": the folder holds no .glb, .gltf or .pack file; name one that holds models, not in folders below it");
  put_clips("moves.gltf");
  EXPECT_EQ(
      refusal(load_cast({&folder, 1})),
      folder_.string() + ": there are clips and no character to play them; give the file of a character with them");
}

TEST_F(CastFiles, ThatAreTooManyAreRefused) {
  for (std::size_t i = 0; i <= most_models; ++i) put("no-animation.glb", std::to_string(i) + ".glb");
  const CastEntry folder{.file = folder_.string()};
  EXPECT_EQ(refusal(load_cast({&folder, 1})),
            folder_.string() +
                ": with it there are more than 30 characters, the most of one crowd; name fewer, as in --cast "
                "FILE,FILE");
  fs::remove(folder_ / "7.glb");
  EXPECT_EQ(refusal(load_cast({&folder, 1})), "(taken)");
}

TEST_F(CastFiles, WithoutAMeshAreRefusedInWords) {
  const std::string file = (folder_ / "no_mesh.gltf").string();
  put_text("no_mesh.gltf", R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"name":"a"}],)"
                           R"("skins":[{"joints":[0]}]})");
  EXPECT_EQ(refusal(load_cast(cast_of({&file, 1}))),
            file + ": it has a skeleton of 1 bone, but no mesh to draw; export it into one .glb with its mesh");
}

TEST_F(CastFiles, KnowWhoseColoursAreTheirFilesOwn) {
  const std::vector<std::string> files{put("plain.glb", "a.glb").string(),
                                       std::string(THRONG_SOURCE_DIR) + "/assets/mannequin.glb#all"};
  const auto cast = load_cast(cast_of(files));
  ASSERT_TRUE(cast) << cast.error().message;
  ASSERT_EQ(cast->characters.size(), 2U);
  EXPECT_TRUE(cast->characters[0].roles.is_painted);
  EXPECT_FALSE(cast->characters[1].roles.is_painted) << "the mannequin has tint regions";
}

}  // namespace
}  // namespace throng::app::cast_files_test
