#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/import/import.h"
#include "tests/import/test_files.h"

namespace throng::import::testing::data_keys_test {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A file whose first animation, "Walk", has these extras.
json document_with_extras(const json& extras) {
  json document = read_json(data_path("features/data-uri.gltf"));
  document["animations"][0]["name"] = "Walk";
  document["animations"][0]["extras"] = extras;
  return document;
}

json data_keys(const json& keys) { return {{"throng_data_keys", keys}}; }

anim::ImportedFile import_with_extras(const json& extras) {
  const TemporaryFolder folder;
  return import_good(folder.write("walk.gltf", document_with_extras(extras).dump()));
}

std::string refusal_of(const json& extras) {
  const TemporaryFolder folder;
  const auto file = import_file(folder.write("walk.gltf", document_with_extras(extras).dump()).string());
  return file ? "" : file.error().message;
}

const anim::Clip& first_clip(const anim::ImportedFile& file) { return file.models.front().clips.front(); }

std::vector<std::string> names(const anim::ImportedFile& file) {
  std::vector<std::string> result;
  for (const anim::NamedDataKey& key : first_clip(file).data_keys) result.push_back(key.name);
  return result;
}

TEST(DataKeysOfAFile, StandInTheExtrasOfItsAnimationsInAnyOrder) {
  const anim::ImportedFile file = import_with_extras(data_keys(
      {{{"time", 0.5}, {"name", "right"}}, {{"time", 0}, {"name", "start"}}, {{"time", 0.25}, {"name", "left"}}}));
  EXPECT_THAT(names(file), ElementsAre("start", "left", "right"));
  EXPECT_EQ(first_clip(file).data_keys[1].time, 0.25);
  EXPECT_THAT(file.repairs, IsEmpty());
}

TEST(DataKeysOfAFile, OutsideOfTheAnimationAreLeftOutAndReported) {
  const anim::ImportedFile file = import_with_extras(data_keys(
      {{{"time", 99}, {"name", "late"}}, {{"time", -0.5}, {"name", "early"}}, {{"time", 0.1}, {"name", "in"}}}));
  EXPECT_THAT(names(file), ElementsAre("in"));
  EXPECT_THAT(file.repairs,
              ElementsAre(HasSubstr("animation 0 \"Walk\": data key \"late\" at 99"), HasSubstr("\"early\"")));
}

TEST(DataKeysOfAFile, ThatAreLateByRoundingStandAtTheEnd) {
  const double duration = first_clip(import_with_extras(json::object())).duration;
  const anim::ImportedFile file = import_with_extras(data_keys({{{"time", duration + 0.0005}, {"name", "end"}}}));
  ASSERT_THAT(names(file), ElementsAre("end"));
  EXPECT_EQ(first_clip(file).data_keys.front().time, duration);
}

TEST(DataKeysOfAFile, AreRefusedInWordsWhereTheyAreNone) {
  EXPECT_THAT(refusal_of(data_keys("footstep")),
              EndsWith("animation 0 \"Walk\": \"throng_data_keys\" is not an array; export the file again"));
  EXPECT_THAT(refusal_of(data_keys({0.31})), HasSubstr("holds what is not an object"));
  EXPECT_THAT(refusal_of(data_keys({{{"name", "left"}}})),
              EndsWith("animation 0 \"Walk\", data key 0 \"left\": \"time\" is missing; export the file again"));
  EXPECT_THAT(refusal_of(data_keys({{{"time", "soon"}, {"name", "left"}}})), HasSubstr("\"time\" is not a number"));
  EXPECT_THAT(refusal_of(data_keys({{{"time", 0.1}, {"name", 7}}})), HasSubstr("\"name\" is not a text"));
  EXPECT_THAT(refusal_of(data_keys({{{"time", 0.1}, {"name", ""}}})), HasSubstr("a data key has no name; give it one"));
}

TEST(DataKeysOfAFile, AreNotSoughtInOtherExtras) {
  for (const json& extras : {json("a text"), json({1, 2}), json(nullptr), json({{"author", "somebody"}})}) {
    const anim::ImportedFile file = import_with_extras(extras);
    EXPECT_THAT(names(file), IsEmpty()) << extras;
    EXPECT_THAT(file.repairs, IsEmpty()) << extras;
  }
}

}  // namespace
}  // namespace throng::import::testing::data_keys_test
