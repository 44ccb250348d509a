// Rules of who wears what, in recordings and out of them.

#include <algorithm>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/people/wardrobe/cast_rules_text.h"
#include "app/show/request/crowd_file.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "tests/app/program_run.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::replay_rules_test {
namespace {

namespace fs = std::filesystem;
using test::demo;
using test::show_of;
using testing::HasSubstr;

const fs::path built_in = fs::path(THRONG_SOURCE_DIR) / "assets/cast.json";

/// Rules of a user's own, which give the children half of all places and everybody more to hold.
class RulesShow : public test::RecordedRun {
 protected:
  RulesShow() {
    CastRules rules = *read_cast_rules(built_in);
    rules.bodies.back().share = 80.0F;
    rules.things = 20.0F;
    EXPECT_TRUE(write_cast_rules(rules_, rules));
  }
  std::string line() const { return "--agents 60 --wardrobe on --cast " + rules_.string(); }
  std::string all_equal() const { return file_.string() + ": all 30 frames are equal, the last of 60 agents"; }
  static void nothing(Show& /*show*/, int /*frame*/) {}

  const fs::path rules_ = folder_ / "mine.json";
};

TEST_F(RulesShow, IsRepeatedWhenItsFileOfRulesWasEditedOrIsGone) {
  record(*show_of(demo(line())), 30, nothing);
  EXPECT_EQ(repeated(""), all_equal());
  fs::copy_file(built_in, rules_, fs::copy_options::overwrite_existing);
  EXPECT_EQ(repeated(""), all_equal());
  fs::remove(rules_);
  EXPECT_EQ(repeated(""), all_equal());
}

TEST_F(RulesShow, IsRepeatedWithTheRulesThatWereTunedWhileItWasRecorded) {
  record(*show_of(demo(line())), 30, [](Show& show, int frame) {
    if (frame != 10 && frame != 20) return;
    CastRules rules = show.stage().clothing()[0].rules;
    rules.bodies.front().share = frame == 10 ? 0.0F : 300.0F;
    rules.seed += 1;
    EXPECT_TRUE(show.take(SetRules{0, rules_text(rules)}));
  });
  EXPECT_EQ(repeated(""), all_equal());
}

TEST_F(RulesShow, SaysWhichPartIsNotThereAnyMore) {
  record(*show_of(demo(line())), 2, nothing);
  std::string other = bytes();
  for (std::size_t at = 0; (at = other.find("\"jeans\"", at)) != std::string::npos;) other.replace(at, 7, "\"jaens\"");
  put(test::with_true_checksum(other));
  EXPECT_THAT(repeated(""), HasSubstr("the rules kept for mannequin (built in): style"));
  EXPECT_THAT(repeated(""), HasSubstr("wears \"jaens\", which no part is called; the nearest are jeans"));
  EXPECT_THAT(repeated(""), testing::StartsWith(file_.string() + ": "));
}

TEST_F(RulesShow, TakesNoOtherRulesForAReplay) {
  const std::string said = "--cast: the recording says it; leave it out with --replay";
  const ProgramRun run = run_program({"--headless=none", "--replay", file_.string(), "--cast", rules_.string()});
  EXPECT_EQ(run.exit_status, 2);
  EXPECT_THAT(run.errors, HasSubstr(said));
}

TEST_F(RulesShow, KeepsItsRulesWhenACharacterGetsAnotherSize) {
  const auto show = show_of(demo(line()));
  const CastRules before = show->stage().clothing()[0].rules;
  ASSERT_TRUE(show->take(SetPlacement{0, {.scale = 1.1}}));
  EXPECT_EQ(show->stage().clothing()[0].rules, before);
  EXPECT_EQ(show->stage().people().front().cast_rules, rules_.string());
}

TEST_F(RulesShow, IsKeptInACrowdFileWhereSomebodyChoseIt) {
  const fs::path crowd = folder_ / "mine.throng";
  const auto chosen = show_of(demo(line()));
  ASSERT_TRUE(write_crowd_file(crowd, crowd_setup(chosen->stage().people(), {chosen->stage().tuning(), {}})));
  fs::remove(rules_);
  const auto again = show_of(demo(crowd.string()));
  EXPECT_EQ(again->stage().clothing()[0].rules, chosen->stage().clothing()[0].rules);
  EXPECT_EQ(crowd_setup(again->stage().people(), {}).characters, read_crowd_file(crowd)->characters);
  const auto usual = show_of(demo("--agents 3 --wardrobe on"));
  EXPECT_FALSE(crowd_setup(usual->stage().people(), {}).characters.front().rules) << "it is what the program brings";
  ASSERT_TRUE(usual->take(SetPlacement{0, {.scale = 1.1}}));
  EXPECT_FALSE(crowd_setup(usual->stage().people(), {}).characters.front().rules) << "another size chooses no rules";
  CastRules tuned = usual->stage().clothing()[0].rules;
  tuned.things = 3.0F;
  ASSERT_TRUE(usual->take(SetRules{0, rules_text(tuned)}));
  EXPECT_TRUE(crowd_setup(usual->stage().people(), {}).characters.front().rules);
}

TEST_F(RulesShow, RefusesRulesThatNameNoPartAndGoesOnWithItsOwn) {
  const auto show = show_of(demo(line()));
  const CastRules before = show->stage().clothing()[0].rules;
  CastRules wrong = before;
  wrong.styles.front().wears.front().parts.front().name = "toga";
  const Status set = show->take(SetRules{0, rules_text(wrong)});
  ASSERT_FALSE(set);
  EXPECT_THAT(set.error().message, HasSubstr("wears \"toga\", which no part is called"));
  EXPECT_EQ(show->stage().clothing()[0].rules, before);
}

TEST_F(RulesShow, GivesEverybodyOtherClothesForAnotherSeedAndNothingToHoldWithoutThings) {
  const auto show = show_of(demo(line()));
  const auto outfits = show->stage().crowd().looks().outfits;
  CastRules rules = show->stage().clothing()[0].rules;
  rules.seed += 1;
  ASSERT_TRUE(show->take(SetRules{0, rules_text(rules)}));
  int same = 0;
  for (std::size_t agent = 0; agent < outfits.size(); ++agent) {
    same += outfits[agent] == show->stage().crowd().looks().outfits[agent] ? 1 : 0;
  }
  EXPECT_LT(same, 6) << "of 60";
  const auto held = [&] {
    const auto& in_hand = show->stage().crowd().looks().in_hand;
    return in_hand.size() - static_cast<std::size_t>(std::ranges::count(in_hand, render::Outfit::no_piece));
  };
  EXPECT_GT(held(), 20U);
  rules.things = 0.0F;
  ASSERT_TRUE(show->take(SetRules{0, rules_text(rules)}));
  EXPECT_LT(held(), 4U) << "who takes pictures brings a camera";
}

}  // namespace
}  // namespace throng::app::replay_rules_test
