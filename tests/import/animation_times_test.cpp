#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/import/import.h"
#include "tests/import/test_files.h"

namespace throng::import::testing::animation_times_test {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A file whose animation has keys at 100, 100.5, 101 and 101.5 s. Accessor `single` has one key time, 0 s.
json late_document(std::size_t& single) {
  json document = read_json(data_path("features/data-uri.gltf"));
  document["buffers"].push_back(
      {{"byteLength", 20}, {"uri", "data:application/octet-stream;base64,AADIQgAAyUIAAMpCAADLQgAAAAA="}});
  const std::size_t view = document["bufferViews"].size();
  document["bufferViews"].push_back({{"buffer", 1}, {"byteOffset", 0}, {"byteLength", 16}});
  document["bufferViews"].push_back({{"buffer", 1}, {"byteOffset", 16}, {"byteLength", 4}});
  const std::size_t times = document["accessors"].size();
  const auto add_times = [&](std::size_t in_view, int count, double least, double most) {
    document["accessors"].push_back({{"componentType", 5126},
                                     {"count", count},
                                     {"type", "SCALAR"},
                                     {"bufferView", in_view},
                                     {"min", {least}},
                                     {"max", {most}}});
  };
  add_times(view, 4, 100.0, 101.5);
  add_times(view + 1, 1, 0.0, 0.0);
  single = times + 1;
  for (json& sampler : document["animations"][0]["samplers"]) sampler["input"] = times;
  return document;
}

anim::ImportedFile import_document(const json& document) {
  const TemporaryFolder folder;
  return import_good(folder.write("late.gltf", document.dump()));
}

const anim::Clip& clip_of(const anim::ImportedFile& file) { return file.models.front().clips.front(); }

TEST(AnimationTimes, OfAClipBeginAtItsFirstKey) {
  std::size_t single = 0;
  const anim::ImportedFile file = import_document(late_document(single));
  EXPECT_EQ(clip_of(file).start, 100.0);
  EXPECT_EQ(clip_of(file).duration, 101.5);
  EXPECT_EQ(clip_of(file).length(), 1.5);
}

TEST(AnimationTimes, AreNotThoseOfASingleKeyWhichHoldsAtAllTimes) {
  std::size_t single = 0;
  json document = late_document(single);
  json& animation = document["animations"][0];
  json one = document["accessors"][5];
  one["count"] = 1;
  animation["samplers"][0] = {{"input", single}, {"output", document["accessors"].size()}};
  document["accessors"].push_back(one);
  EXPECT_EQ(clip_of(import_document(document)).start, 100.0);
}

TEST(AnimationTimes, OfSingleKeysAloneMakeAClipWithoutLength) {
  std::size_t single = 0;
  json document = late_document(single);
  json& animation = document["animations"][0];
  json one = document["accessors"][5];
  one["count"] = 1;
  const std::size_t output = document["accessors"].size();
  document["accessors"].push_back(one);
  for (json& sampler : animation["samplers"]) sampler = {{"input", single}, {"output", output}};
  const anim::ImportedFile file = import_document(document);
  EXPECT_EQ(clip_of(file).length(), 0.0);
}

TEST(AnimationTimes, OfDataKeysBeforeTheFirstKeyMoveThereAndAreReported) {
  std::size_t single = 0;
  json document = late_document(single);
  document["animations"][0]["extras"] = {
      {"throng_data_keys", {{{"time", 0}, {"name", "early"}}, {{"time", 100.5}, {"name", "in"}}}}};
  const anim::ImportedFile file = import_document(document);
  ASSERT_EQ(clip_of(file).data_keys.size(), 2U);
  EXPECT_EQ(clip_of(file).data_keys[0].time, 100.0);
  EXPECT_EQ(clip_of(file).data_keys[1].time, 100.5);
  EXPECT_THAT(file.repairs, ElementsAre(HasSubstr("\"early\" at 0.000000 s lies before the first key, moved there")));
}

}  // namespace
}  // namespace throng::import::testing::animation_times_test
