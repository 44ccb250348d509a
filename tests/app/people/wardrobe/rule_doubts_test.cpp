#include "app/people/wardrobe/rule_doubts.h"

#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::app::rule_doubts_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string good = R"({"version": 1,
  "bodies": {"man": {"share": 3}, "woman": {"share": 2}},
  "skin": ["head", "legs"],
  "colours": {"reds": ["#C8102E"]},
  "clothes": {"shirt": {"colours": "reds", "patterns": {"plain": 2}}},
  "styles": {"casual": {"wears": {"top": {"shirt": 1}, "bottom": {"jeans": 1, "none": 1}}}},
  "scenes": {"any": {"casual": 1}},
  "weather": {"cold": {"warm": 4}}})";

anim::ModelPart part(const std::string& name, const std::string& slot, std::vector<std::string> covers = {}) {
  anim::ModelPart made;
  made.name = name;
  made.slot = slot;
  made.covers = std::move(covers);
  return made;
}

Wardrobe wardrobe() {
  anim::ModelPart shirt = part("shirt", "top");
  shirt.tags = {"warm"};
  return Wardrobe(std::vector{part("face", "head"), part("thighs", "legs"), shirt, part("jumper", "top"),
                              part("jeans", "bottom", {"legs"}), part("shorts", "bottom", {"legs"})});
}

/// Returns the doubts about the good rules with one text in the place of another.
std::vector<std::string> doubts_with(const std::string& text, const std::string& other,
                                     const Wardrobe& worn = wardrobe()) {
  std::string rules = good;
  const std::size_t place = rules.find(text);
  EXPECT_NE(place, std::string::npos) << text;
  rules.replace(place, text.size(), other);
  const auto read = cast_rules(*parse_json(rules));
  EXPECT_TRUE(read) << read.error().message;
  return read ? doubts_of(*read, worn) : std::vector<std::string>();
}

TEST(RuleDoubts, AreNoneAboutRulesThatCanBeMeant) {
  EXPECT_THAT(doubts_with("", ""), IsEmpty());
  EXPECT_THAT(doubts_with("", "", Wardrobe()), IsEmpty()) << "nothing is drawn";
  EXPECT_THAT(doubts_of(even_rules(wardrobe()), wardrobe()), IsEmpty());
}

TEST(RuleDoubts, NameASceneThatIsNone) {
  EXPECT_THAT(doubts_with("\"any\"", "\"plazza\""),
              ElementsAre(HasSubstr("scene \"plazza\": no scene is called that; the nearest are plaza, ")));
  EXPECT_THAT(doubts_with("{\"any\"", "{\"plaza\": {\"casual\": 1}, \"any\""),
              ElementsAre(HasSubstr("scene \"any\" is not the first, which is for all scenes that are not named")));
}

TEST(RuleDoubts, NameWeightsThatAreAllZero) {
  EXPECT_THAT(doubts_with("\"any\": {\"casual\": 1}", "\"any\": {\"casual\": 0}"),
              ElementsAre("scene \"any\": all weights are 0, so all agents wear the first style, \"casual\"; give a "
                          "style a weight above 0"));
  EXPECT_THAT(doubts_with("\"shirt\": 1", "\"shirt\": 0"),
              ElementsAre(HasSubstr("style \"casual\" gives no part of \"top\" a weight above 0, so no agent wears")));
  EXPECT_THAT(doubts_with("\"plain\": 2", "\"plain\": 0"),
              ElementsAre(HasSubstr("clothes \"shirt\": the weights of all patterns are 0, so it is plain")));
  EXPECT_THAT(doubts_with("{\"share\": 3}, \"woman\": {\"share\": 2}", "{\"share\": 0}, \"woman\": {\"share\": 0}"),
              ElementsAre(HasSubstr("the shares of all bodies are 0, so every agent is the last one, \"woman\"")));
}

TEST(RuleDoubts, NameABodyWithoutAStyle) {
  EXPECT_THAT(
      doubts_with("{\"wears\"", "{\"bodies\": [\"man\"], \"wears\""),
      ElementsAre(HasSubstr("scene \"any\": no style is for the body \"woman\", which wears \"casual\" for want")));
}

TEST(RuleDoubts, NameWhatNothingUses) {
  EXPECT_THAT(doubts_with("\"styles\": {", "\"styles\": {\"formal\": {\"wears\": {}},"),
              ElementsAre("no scene has the style \"formal\"; use it, or take it out"));
  EXPECT_THAT(doubts_with("{\"reds\"", "{\"blues\": [\"#0000FF\"], \"pinks\": [\"#FF8080\"], \"reds\""),
              ElementsAre("nothing has the colours \"blues\" or \"pinks\"; use it, or take it out"));
}

TEST(RuleDoubts, NameWhatTheModelLacks) {
  EXPECT_THAT(doubts_with("{\"shirt\": {", "{\"shrit\": {"),
              ElementsAre(HasSubstr("clothes \"shrit\": no part is called that; the nearest are shirt")));
  EXPECT_THAT(doubts_with("[\"head\"", "[\"heads\""),
              ElementsAre(HasSubstr("\"skin\": no part is for the slot \"heads\"; the nearest are head")));
  EXPECT_THAT(doubts_with("\"top\"", "\"tops\""),
              ElementsAre(HasSubstr("style \"casual\": no part is for the slot \"tops\"; the nearest are top")));
  EXPECT_THAT(doubts_with("\"warm\"", "\"wram\""),
              ElementsAre(HasSubstr("weather \"cold\": no part has the tag \"wram\"")));
  EXPECT_THAT(doubts_with("\"cold\"", "\"frost\""),
              ElementsAre("weather \"frost\": no weather is called that; there are mild, warm, cold and rain"));
}

TEST(RuleDoubts, NameThePiecesOfABodyThatAStyleLacks) {
  EXPECT_THAT(doubts_with("\"head\", \"legs\"", "\"head\""), IsEmpty()) << "jeans cover legs";
  const std::string bottom = "\"skin\": [\"head\", \"legs\"]";
  std::string rules = good;
  rules.replace(rules.find(bottom), bottom.size(), "\"skin\": [\"head\"]");
  const std::string jeans = ", \"bottom\": {\"jeans\": 1, \"none\": 1}";
  rules.replace(rules.find(jeans), jeans.size(), "");
  EXPECT_THAT(
      doubts_of(*cast_rules(*parse_json(rules)), wardrobe()),
      ElementsAre("style \"casual\" leaves the body \"man\" without legs; add them to \"skin\", or clothes that "
                  "cover them"));
}

}  // namespace
}  // namespace throng::app::rule_doubts_test
