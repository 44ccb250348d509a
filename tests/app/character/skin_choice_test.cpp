#include "app/character/skin_choice.h"

#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/show/figures/notices.h"
#include "engine/anim/asset/synthetic_model.h"

namespace throng::app::skin_choice_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

anim::Model model_named(const std::string& skin, const std::string& mesh, bool has_mesh = true) {
  anim::Model model = anim::synthetic_model(3, 1);
  model.skeleton.name = skin;
  model.skins.resize(1);
  model.skins.front().name = skin;
  model.meshes.clear();
  if (has_mesh) model.meshes.emplace_back().name = mesh;
  return model;
}

anim::ImportedFile cast() {
  anim::ImportedFile file;
  file.file = "scene.glb";
  file.models.push_back(model_named("Knight", "body"));
  file.models.push_back(model_named("Armature", "mage"));
  file.models.push_back(model_named("Armature", ""));
  file.models.push_back(model_named("bones alone", "", false));
  return file;
}

TEST(CharacterNames, TellCharactersApartAndLeaveOutSkeletonsWithoutAMesh) {
  EXPECT_THAT(character_names(cast()), ElementsAre("Knight", "mage", "3"));
}

TEST(ChosenModel, IsTheLargestUnlessOneIsNamed) {
  const anim::ImportedFile file = cast();
  EXPECT_EQ(*choose_model(file, ""), 0U);
  EXPECT_EQ(*choose_model(file, "mage"), 1U);
  EXPECT_EQ(*choose_model(file, "3"), 2U);
  EXPECT_EQ(*choose_model(file, "2"), 1U) << "by its number, too";
  EXPECT_EQ(*choose_model(file, "body"), 0U) << "by its mesh, too";
  EXPECT_EQ(choose_model(file, "Rogue").error().message,
            "scene.glb: it has no skin \"Rogue\"; it has Knight, mage and 3");
}

TEST(CharacterFile, IsAFileAndASkin) {
  EXPECT_EQ(character_file("a/b.glb").skin, "");
  EXPECT_EQ(character_file("a/b.glb#Knight").path, "a/b.glb");
  EXPECT_EQ(character_file("a/b.glb#Knight").skin, "Knight");
  EXPECT_EQ(with_skin("b.glb", "Knight"), "b.glb#Knight");
  EXPECT_EQ(with_skin("b.glb#Mage", "Knight"), "b.glb#Mage");
  const std::string odd = testing::TempDir() + "odd#name.glb";
  std::ofstream(odd) << "x";
  EXPECT_EQ(character_file(odd).path, odd) << "a file of that name goes first";
}

CharacterSource source_with(std::vector<std::string> repairs, std::vector<std::string> names = {}) {
  CharacterSource source;
  source.file = "folder/person.glb";
  source.repairs = std::move(repairs);
  source.cast = std::move(names);
  return source;
}

TEST(ImportNotice, SaysWhatWasRepairedOnceAFile) {
  const CharacterSource sources[] = {source_with({"image 0: left out"}), source_with({"image 0: left out"})};
  EXPECT_EQ(import_notice(sources), "person.glb: image 0: left out.");
  EXPECT_THAT(import_notice({}), IsEmpty());
}

TEST(ImportNotice, KeepsToAFewLines) {
  const CharacterSource source = source_with({"a", "b", "c", "d", "e"});
  EXPECT_EQ(import_notice({&source, 1}),
            "person.glb: a.\nperson.glb: b.\nperson.glb: c.\nperson.glb: 2 more things "
            "were repaired or left out; throng inspect lists them.");
}

TEST(ImportNotice, KeepsToAFewLinesAboutClipsOfOtherFiles) {
  CharacterSource source = source_with({});
  source.notes = {"a", "b", "c", "d", "e"};
  EXPECT_THAT(import_notice({&source, 1}), HasSubstr("person.glb: c.\nperson.glb: 2 more such notes; throng inspect"));
}

TEST(ImportNotice, ListsTheOtherCharactersOfAFile) {
  CharacterSource source = source_with({}, {"Knight", "Mage"});
  EXPECT_THAT(import_notice({&source, 1}), HasSubstr("shown is Knight of 2 characters, Knight and Mage; --skin NAME"));
  source.file += "#Knight";
  EXPECT_THAT(import_notice({&source, 1}), IsEmpty()) << "a person chose it";
}

}  // namespace
}  // namespace throng::app::skin_choice_test
