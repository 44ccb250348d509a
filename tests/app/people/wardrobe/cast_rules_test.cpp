#include "app/people/wardrobe/cast_rules.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::app::cast_rules_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::string good = R"({"version": 1,
  "bodies": {"man": {"share": 3, "size": 1.0}, "woman": {"size": 0.93}},
  "skin": ["head"],
  "colours": {"reds": ["#C8102E", "#FF0000"]},
  "clothes": {"t_shirt": {"colours": "reds", "patterns": {"plain": 2, "dots": 1}, "fabric": "wool"}},
  "styles": {"casual": {"bodies": ["man"], "wears": {"top": {"t_shirt": 1, "none": 2}}, "colours": {"top": "team"}}},
  "scenes": {"any": {"casual": 1}},
  "weather": {"cold": {"warm": 4}},
  "teams": [["#102030", "#FFFFFF"]]})";

Result<CastRules> read(const std::string& text) { return cast_rules(*parse_json(text)); }

/// Returns the complaint about the good rules with one text in the place of another.
std::string complaint_with(const std::string& text, const std::string& other) {
  std::string rules = good;
  const std::size_t place = rules.find(text);
  EXPECT_NE(place, std::string::npos) << text;
  rules.replace(place, text.size(), other);
  const auto read_rules = read(rules);
  return read_rules ? "(taken)" : read_rules.error().message;
}

TEST(CastRules, SayWhoWearsWhat) {
  const auto rules = read(good);
  ASSERT_TRUE(rules) << rules.error().message;
  ASSERT_THAT(rules->bodies, SizeIs(2));
  EXPECT_EQ(rules->bodies[0].share, 3.0F);
  EXPECT_EQ(rules->bodies[1].size, 0.93F);
  EXPECT_EQ(rules->palette("reds")->colors.front(), 0x2E10C8U) << "red in the lowest byte";
  EXPECT_EQ(rules->cloth("t_shirt")->fabric, render::Fabric::wool);
  EXPECT_EQ(rules->cloth("t_shirt")->patterns.back().first, render::Pattern::dots);
  EXPECT_EQ(rules->style("casual")->wears.front().parts.back().name, nothing_worn);
  EXPECT_EQ(rules->scene("parade"), &rules->scenes.front()) << "a scene without rules has those of the first";
  EXPECT_EQ(rules->teams.front().second, 0xFFFFFFU);
}

TEST(CastRules, RefuseWhatTheyCannotMean) {
  EXPECT_THAT(complaint_with("\"dots\"", "\"dotty\""), HasSubstr("no pattern is called \"dotty\"; there are plain,"));
  EXPECT_THAT(complaint_with("\"wool\"", "\"silk\""), HasSubstr("no fabric is called \"silk\"; there are cotton,"));
  EXPECT_THAT(complaint_with("#FF0000", "red"), HasSubstr("colours \"reds\" must be an array of colours like"));
  EXPECT_THAT(complaint_with("\"t_shirt\": 1,", "\"t_shirt\": -1,"), HasSubstr("the weight of \"t_shirt\" must be"));
  EXPECT_THAT(complaint_with("{\"casual\": 1}", "{\"formal\": 1}"), HasSubstr("no style is called \"formal\""));
  EXPECT_THAT(complaint_with("\"team\"", "\"blues\""), HasSubstr("no colours are called \"blues\""));
  EXPECT_THAT(complaint_with("[\"man\"]", "[\"men\"]"), HasSubstr("no body is called \"men\""));
  EXPECT_THAT(complaint_with("\"share\": 3", "\"share\": \"many\""), HasSubstr("\"share\" must be a number"));
  EXPECT_THAT(complaint_with("\"weather\"", "\"wether\""), HasSubstr("unknown key \"wether\""));
  EXPECT_THAT(complaint_with("\"version\": 1", "\"version\": 2"), HasSubstr("\"version\" must be 1"));
  EXPECT_THAT(complaint_with("{\"t_shirt\": 1, \"none\": 2}", "1"), HasSubstr("must be an object of names"));
  EXPECT_THAT(complaint_with("{\"cold\": {\"warm\": 4}}", "4"), HasSubstr("\"weather\" must be an object"));
}

TEST(CastRules, RefuseACrowdWithoutBodiesOrAStyle) {
  const std::string bodies = R"({"man": {"share": 3, "size": 1.0}, "woman": {"size": 0.93}})";
  EXPECT_THAT(complaint_with("\"bodies\": " + bodies + ",", ""), HasSubstr("\"bodies\" is missing"));
  EXPECT_THAT(complaint_with(bodies, "[]"), HasSubstr("\"bodies\" must be an object"));
  EXPECT_THAT(complaint_with(bodies, "{}"), HasSubstr("\"bodies\" must name a body, as in {\"man\": {}}"));
  EXPECT_THAT(complaint_with("{\"any\": {\"casual\": 1}}", "{}"), HasSubstr("\"scenes\" must name a scene"));
  EXPECT_THAT(complaint_with("{\"casual\": 1}}", "{\"casual\": 1}, \"parade\": {}}"),
              HasSubstr("scene \"parade\" must name a style"));
  std::string many = "{\"man\": {}";
  for (int body = 0; body < 256; ++body) many += ", \"" + std::to_string(body) + "\": {}";
  EXPECT_THAT(complaint_with(bodies, many + "}"), HasSubstr("\"bodies\" has 257 bodies, and 256 are the most"));
}

TEST(CastRules, HaveNoMoreColoursThanCanBeToldApartInTime) {
  const std::string red = "\"#FF0000\"";
  std::string many = red;
  for (int color = 1; color < 999; ++color) many += ", " + red;  // and the other of "reds"
  EXPECT_EQ(complaint_with(red, many), "(taken)");
  EXPECT_THAT(complaint_with(red, many + ", " + red), HasSubstr("\"colours\" must be at most 1000 in all"));
}

Wardrobe wardrobe_of(std::initializer_list<const char*> names) {
  std::vector<anim::ModelPart> parts;
  for (const char* name : names) {
    anim::ModelPart& part = parts.emplace_back();
    part.name = name;
    part.slot = "top";
  }
  return Wardrobe(parts);
}

TEST(CastRules, NameTheNearestOfAnUnknownPart) {
  const auto rules = read(good);
  EXPECT_THAT(unknown_in(*rules, wardrobe_of({"t_shirt"})), IsEmpty());
  EXPECT_THAT(unknown_in(*rules, wardrobe_of({"tshirt", "jeans"})),
              HasSubstr("style \"casual\" wears \"t_shirt\", which no part is called; the nearest are tshirt"));
}

TEST(CastRules, OfAFileWithoutAnyGiveEachPartTheSameChance) {
  const CastRules rules = even_rules(wardrobe_of({"t_shirt", "blouse"}));
  ASSERT_THAT(rules.styles, SizeIs(1));
  ASSERT_THAT(rules.styles.front().wears, SizeIs(1));
  EXPECT_THAT(rules.styles.front().wears.front().parts, SizeIs(2));
  EXPECT_THAT(rules.bodies, SizeIs(1));
}

}  // namespace
}  // namespace throng::app::cast_rules_test
