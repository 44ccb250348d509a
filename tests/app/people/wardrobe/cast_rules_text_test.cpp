// Rules as text, and what a person tunes of them.

#include "app/people/wardrobe/cast_rules_text.h"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/people/wardrobe/cast_tuning.h"
#include "tests/app/temporary_folder.h"

namespace throng::app::cast_rules_text_test {
namespace {

using testing::HasSubstr;

const std::filesystem::path built_in = std::filesystem::path(THRONG_SOURCE_DIR) / "assets/cast.json";

CastRules rules() {
  auto read = read_cast_rules(built_in);
  EXPECT_TRUE(read) << read.error().message;
  return std::move(*read);
}

class CastRulesFile : public test::TemporaryFolder {};

TEST_F(CastRulesFile, IsReadAsTheRulesThatWereWritten) {
  CastRules written = rules();
  ASSERT_GT(written.styles.size(), 3U);
  ASSERT_GT(written.teams.size(), 0U);
  written.things = 2.5F;
  written.seed = 4'294'967'295U;
  const std::filesystem::path file = folder_ / "mine.cast.json";
  ASSERT_TRUE(write_cast_rules(file, written));
  const auto read = read_cast_rules(file);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(*read, written);
  EXPECT_EQ(rules_text(*read), rules_text(written)) << "a recording compares texts";
}

TEST_F(CastRulesFile, HasNumbersAndColoursAsPeopleWriteThem) {
  const std::string text = to_json(rules()).dump(2);
  EXPECT_THAT(text, HasSubstr("\"#2F4A63\""));
  EXPECT_THAT(text, HasSubstr("0.66"));
  EXPECT_EQ(text.find("0000000"), std::string::npos) << "a float of 0.66 is no 0.66000002";
}

TEST_F(CastRulesFile, ThatCannotBeWrittenIsNamedAndLeavesNothing) {
  const std::filesystem::path file = folder_ / "none" / "mine.cast.json";
  const Status written = write_cast_rules(file, rules());
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, HasSubstr("mine.cast.json"));
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST(RulesText, OfNobodyWhoDressesIsEmpty) {
  EXPECT_EQ(rules_text(CastRules()), "");
  EXPECT_EQ(*rules_of_text(""), CastRules());
}

TEST(RulesText, RefusesASeedAndThingsThatCannotBe) {
  for (const char* const wrong : {R"("seed": -1)", R"("things": 101)", R"("things": "many")"}) {
    const auto read = rules_of_text(
        std::string(
            R"({"version": 1, "bodies": {"man": {}}, "styles": {"a": {"wears": {}}}, "scenes": {"any": {"a": 1}}, )") +
        wrong + "}");
    ASSERT_FALSE(read) << wrong;
    EXPECT_THAT(read.error().message, HasSubstr("must be"));
  }
}

TEST(CastTuning, ChangesSharesStylesThingsAndSeedAndNothingElse) {
  CastRules tuned = rules();
  CastTuning tuning = cast_tuning(tuned, "stadium");
  ASSERT_EQ(tuning.styles.front().name, "fan");
  tuning.bodies.front().weight = 7.0F;
  tuning.styles.front().weight = 9.0F;
  tuning.things = 0.5F;
  tuning.seed = 3;
  tune(tuned, "stadium", tuning);
  EXPECT_EQ(cast_tuning(tuned, "stadium"), tuning);
  EXPECT_EQ(cast_tuning(tuned, "parade").styles, cast_tuning(rules(), "parade").styles);
  CastRules expected = rules();
  expected.bodies.front().share = 7.0F;
  expected.scenes.at(1).styles.front().weight = 9.0F;
  expected.things = 0.5F;
  expected.seed = 3;
  EXPECT_EQ(tuned, expected);
}

TEST(CastTuning, OfASceneWithoutRulesIsThatOfTheFirst) {
  CastRules tuned = rules();
  CastTuning tuning = cast_tuning(tuned, "grid");
  EXPECT_EQ(tuning.styles, tuned.scenes.front().styles);
  tuning.styles.back().weight = 5.0F;
  tuning.styles.push_back({"nobody knows it", 1.0F});
  tune(tuned, "grid", tuning);
  EXPECT_EQ(tuned.scenes.front().styles.back().weight, 5.0F);
  EXPECT_EQ(tuned.scenes.front().styles.size(), rules().scenes.front().styles.size());
}

}  // namespace
}  // namespace throng::app::cast_rules_text_test
