#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/import/import.h"
#include "tests/import/test_files.h"

namespace throng::import::testing::curves_test {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The path of a file whose first animation, "Walk", has these curves.
std::string file_with(const TemporaryFolder& folder, const json& curves) {
  json document = read_json(data_path("features/data-uri.gltf"));
  document["animations"][0]["name"] = "Walk";
  document["animations"][0]["extras"] = {{"curves", curves}, {"other", 1}};
  return folder.write("walk.gltf", document.dump()).string();
}

std::string refusal_of(const json& curves) {
  const TemporaryFolder folder;
  const auto file = import_file(file_with(folder, curves));
  return file ? "" : file.error().message;
}

json curve(const json& times, const json& values) { return {{"times", times}, {"values", values}}; }

TEST(CurvesOfAFile, StandInTheExtrasOfItsAnimationsByName) {
  const TemporaryFolder folder;
  const anim::ImportedFile file =
      import_good(file_with(folder, {{"glow", curve({0, 0.5, 1}, {0, 1.5, 0})}, {"aim", curve({0.25}, {-2})}}));
  EXPECT_THAT(file.repairs, IsEmpty());
  const std::vector<anim::NamedCurve>& curves = file.models.front().clips.front().curves;
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[0].name, "aim");
  EXPECT_EQ(curves[1].name, "glow");
  EXPECT_THAT(curves[1].times, ElementsAre(0.0F, 0.5F, 1.0F));
  EXPECT_THAT(curves[1].values, ElementsAre(0.0F, 1.5F, 0.0F));
}

TEST(CurvesOfAFile, ThatAreNoneAreRefusedByName) {
  EXPECT_THAT(refusal_of({{"glow", curve({0, 1}, {1})}}),
              HasSubstr("animation 0 \"Walk\": curve \"glow\" has 1 values for 2 times"));
  EXPECT_THAT(refusal_of({{"glow", curve(json::array(), json::array())}}), HasSubstr("has 0 values for 0 times"));
  EXPECT_THAT(refusal_of({{"glow", curve({1, 1}, {0, 0})}}), HasSubstr("not after the one before"));
  EXPECT_THAT(refusal_of({{"", curve({1}, {0})}}), HasSubstr("a curve has no name"));
  EXPECT_THAT(refusal_of({{"glow", {{"times", {0, 1}}}}}), HasSubstr("values"));
  EXPECT_THAT(refusal_of({{"glow", curve({"soon"}, {1})}}), HasSubstr("times"));
  EXPECT_THAT(refusal_of("none"), HasSubstr("curves"));
}

}  // namespace
}  // namespace throng::import::testing::curves_test
