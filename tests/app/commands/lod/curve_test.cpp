// `throng lod` tells the truth about bone levels, and writes them for another engine.
#include "app/commands/lod/curve.h"

#include <cstdint>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/show/lod/lod_export.h"
#include "engine/anim/lod/level_of_detail.h"

namespace throng::app::curve_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const CharacterSource& mannequin() {
  static const CharacterSource loaded = *load_character(THRONG_SOURCE_DIR "/assets/mannequin.glb", "mannequin");
  return loaded;
}

LodLevel level(double nanoseconds, double error_metres) {
  LodLevel made;
  made.nanoseconds = nanoseconds;
  made.error_metres = error_metres;
  return made;
}

TEST(LodCurve, ALevelPaysThatSavesATenthAndIsWithinAPixelOfAPersonTenPixelsTall) {
  constexpr double height = 1.8;
  const std::vector<LodLevel> levels{level(1000, 0), level(800, 0.05), level(790, 0.06), level(500, 0.2)};
  EXPECT_THAT(levels_that_pay(levels, height), ElementsAre(true, true, false, false));
  EXPECT_DOUBLE_EQ(pixels_tall_for_one_pixel(levels[1], height), 36.0);
}

TEST(LodCurve, SaysInASentenceWhichLevelDoesNotPay) {
  std::vector<LodLevel> levels = lod_levels(mannequin());
  ASSERT_EQ(levels.size(), 3U);
  levels[2].nanoseconds = levels[1].nanoseconds;
  EXPECT_THAT(curve_as_text(mannequin(), {levels, {}}, 200),
              HasSubstr("Level 2 does not pay: it takes 100% of the time"));
}

TEST(LodCurve, SaysOfEachMeshHowManyTrianglesItHasAndHowFarItIsOff) {
  const LodCurve curve{.bones = lod_levels(mannequin()), .meshes = {{5500, 0.0F}, {1650, 0.0225F}}};
  const std::string text = curve_as_text(mannequin(), curve, 200);
  EXPECT_THAT(text, HasSubstr("1650"));
  EXPECT_THAT(text, HasSubstr("22.5"));
}

LodInForce by_distance() {
  LodInForce lod{.tuning = {}, .pixels_per_unit = 772.0F};
  lod.tuning.lod.rule = LodRule::distance;
  return lod;
}

TEST(LodExport, HoldsWhatAnotherEngineNeeds) {
  const std::vector<LodLevel> levels = lod_levels(mannequin());
  const std::vector<MeshLevel> meshes{{1000, {}}, {250, {0.09F, 0.03F}}};
  const auto json = nlohmann::json::parse(lod_as_json(mannequin(), levels, meshes, by_distance()));
  const anim::Skeleton& skeleton = mannequin().character->skeleton;
  ASSERT_EQ(json["bones"].size(), skeleton.bones.size());
  EXPECT_EQ(json["bones"][0]["bone"], skeleton.bones[0].name);
  EXPECT_TRUE(json["bones"][0]["parent"].is_null());
  ASSERT_EQ(json["bone_levels"].size(), 3U);
  const auto& second = json["bone_levels"][1];
  EXPECT_EQ(second["bones"], skeleton.level_bone_counts[1]);
  EXPECT_EQ(second["from_distance_metres"], 15.0);
  EXPECT_GT(second["error_metres"], 0.0);
  EXPECT_NEAR(second["error_pixels_there"], second["error_metres"].get<double>() * 772.0 / 15.0, 1e-9);
  ASSERT_EQ(json["mesh_levels"].size(), 2U);
  EXPECT_TRUE(json["mesh_levels"][0]["one_pixel_below_pixels_tall"].is_null());
  EXPECT_EQ(json["mesh_levels"][1]["triangles"], 250);
  EXPECT_NEAR(json["mesh_levels"][1]["one_pixel_below_pixels_tall"].get<double>(), 20.0, 0.1);
  ASSERT_EQ(json["intervals"].size(), 8U);
  EXPECT_EQ(json["intervals"][2]["from_distance_metres"], 24.0);
  EXPECT_TRUE(json["clips"].empty()) << "distances are the same for all clips";
}

TEST(LodExport, OfALimitOnTheErrorSaysForEachClipHowItIsUpdatedFromWhichDistance) {
  const auto at = [&](float tolerance) {
    return nlohmann::json::parse(lod_as_json(mannequin(), lod_levels(mannequin()), {},
                                             {.tuning = {},
                                              .character = anim::lod_character(*mannequin().character),
                                              .tolerance_pixels = tolerance,
                                              .pixels_per_unit = 772.0F}));
  };
  const auto fine = at(0.25F), coarse = at(4.0F);
  EXPECT_EQ(fine["in_force"]["rule"], "budget");
  EXPECT_TRUE(fine["intervals"].empty()) << "the distances of the other rule are not in force";
  EXPECT_TRUE(fine["bone_levels"][1]["from_distance_metres"].is_null());
  ASSERT_EQ(fine["clips"].size(), mannequin().clip_names.size() + 1);
  EXPECT_TRUE(fine["clips"][0]["clip"].is_null());
  for (std::size_t clip = 1; clip < fine["clips"].size(); ++clip) {
    EXPECT_EQ(fine["clips"][clip]["clip"], mannequin().clip_names[clip - 1]);
    const auto& rows = fine["clips"][clip]["choices"];
    EXPECT_EQ(rows[0]["from_distance_metres"], 0.0);
    for (std::size_t row = 1; row < rows.size(); ++row) {
      const double metres = rows[row]["from_distance_metres"], off = rows[row]["error_metres"];
      EXPECT_GT(metres, rows[row - 1]["from_distance_metres"].get<double>());
      EXPECT_LE(off * 772.0 / metres, 0.25 * 1.001) << fine["clips"][clip]["clip"] << ", row " << row;
      EXPECT_NEAR(metres, 16 * coarse["clips"][clip]["choices"][row]["from_distance_metres"].get<double>(),
                  1e-3 * metres);
    }
  }
}

TEST(LodExport, NamesNoFolder) {
  CharacterSource source = mannequin();
  source.name = "/somewhere/people/walker.glb";
  EXPECT_EQ(nlohmann::json::parse(lod_as_json(source, {}, {}, by_distance()))["character"], "walker.glb");
}

}  // namespace
}  // namespace throng::app::curve_test
