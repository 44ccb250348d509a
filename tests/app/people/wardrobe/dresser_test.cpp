#include "app/people/wardrobe/dresser.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/people/wardrobe/part_of_piece.h"

namespace throng::app::dresser_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Not;
using testing::UnorderedElementsAre;

/// A part of a wardrobe in few words.
anim::ModelPart part(const std::string& name, const std::string& slot, std::vector<std::string> covers = {},
                     std::vector<std::string> keeps_out = {}, std::vector<std::string> tags = {},
                     const std::string& body = {}) {
  anim::ModelPart made;
  made.name = name;
  made.slot = slot;
  made.body = body;
  made.covers = std::move(covers);
  made.keeps_out = std::move(keeps_out);
  made.tags = std::move(tags);
  return made;
}

class Dressing : public testing::Test {
 protected:
  void read_rules(const std::string& styles, const std::string& more = "") {
    const std::string text = R"({"version": 1, "bodies": {"man": {}, "woman": {}}, "skin": ["head", "torso"],
      "colours": {"red": ["#FF0000"], "blue": ["#0000FF"]}, "teams": [["#111111", "#222222"], ["#333333", "#444444"]],
      "clothes": {"t_shirt": {"colours": "red", "seconds": "blue", "patterns": {"dots": 1}, "fabric": "wool"}},
      )" + more + R"("styles": {)" +
                             styles + R"(}, "scenes": {"any": {"a": 1}}})";
    auto rules = cast_rules(*parse_json(text));
    ASSERT_TRUE(rules) << rules.error().message;
    rules_ = std::move(*rules);
    wardrobe_ = Wardrobe(parts_);
  }

  Dressed dress(const Person& person, std::uint32_t attempt = 0) {
    const Dresser dresser(rules_, wardrobe_, {.scene = "plaza", .weather = weather_, .seed = 7});
    return dresser.dress(person, attempt, look_);
  }

  std::vector<std::string> names(const Dressed& dressed) const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < dressed.outfit.count; ++i) {
      names.push_back(part_of_piece(wardrobe_, dressed.outfit.pieces.at(i)).name);
    }
    return names;
  }

  std::vector<anim::ModelPart> parts_{part("head", "head"),
                                      part("torso", "torso"),
                                      part("t_shirt", "top", {"torso"}),
                                      part("dress", "top", {"torso"}, {"bottom"}, {"skirt"}, "woman"),
                                      part("jeans", "bottom"),
                                      part("coat", "outer", {}, {}, {"coat"}),
                                      part("short_hair", "hair"),
                                      part("helmet", "headgear", {"hair"}),
                                      part("umbrella", "hand_right", {}, {}, {"rain"}),
                                      part("silhouette/trousers/short", "silhouette"),
                                      part("silhouette/skirt/short", "silhouette")};
  std::string weather_ = "mild";
  CastRules rules_;
  Wardrobe wardrobe_;
  render::AgentLook look_{};
};

TEST_F(Dressing, LeavesOutWhatIsCovered) {
  read_rules(R"("a": {"wears": {"top": {"t_shirt": 1}, "hair": {"short_hair": 1}, "headgear": {"helmet": 1}}})");
  EXPECT_THAT(names(dress({})), UnorderedElementsAre("head", "t_shirt", "helmet")) << "no torso, no hair";
}

TEST_F(Dressing, ShowsTheSkinThatNothingCovers) {
  read_rules(R"("a": {"wears": {"top": {"none": 1}, "bottom": {"jeans": 1}}})");
  EXPECT_THAT(names(dress({})), UnorderedElementsAre("head", "torso", "jeans"));
}

TEST_F(Dressing, LeavesASlotEmptyThatAnotherPartKeepsOut) {
  read_rules(R"("a": {"wears": {"top": {"dress": 1}, "bottom": {"jeans": 1}}})");
  EXPECT_THAT(names(dress({.body = 1})), UnorderedElementsAre("head", "dress"));
}

TEST_F(Dressing, DrawsOfATopWhatIsSeenBelowACoat) {
  parts_.push_back(part("t_shirt/below_coat", "top"));
  const auto below = static_cast<std::uint16_t>(parts_.size());
  read_rules(R"("a": {"wears": {"top": {"t_shirt": 1}, "outer": {"coat": 1, "none": 1}}})");
  int coats = 0;
  for (std::uint32_t agent = 0; agent < 20; ++agent) {
    const Dressed dressed = dress({.agent = agent});
    const std::vector<std::string> worn = names(dressed);
    const bool coat = std::ranges::find(worn, "coat") != worn.end();
    EXPECT_THAT(worn, Contains("t_shirt"));
    EXPECT_EQ(std::ranges::find(dressed.outfit.pieces, below) != dressed.outfit.pieces.end(), coat);
    coats += coat ? 1 : 0;
  }
  EXPECT_GT(coats, 3);
  EXPECT_LT(coats, 17);
}

TEST_F(Dressing, GivesNobodyAPartOfAnotherBody) {
  read_rules(R"("a": {"wears": {"top": {"dress": 9, "t_shirt": 1}}})");
  for (std::uint32_t agent = 0; agent < 50; ++agent) {
    EXPECT_THAT(names(dress({.agent = agent, .body = 0})), Not(Contains("dress")));
  }
}

TEST_F(Dressing, TakesTheSilhouetteOfTheOutfit) {
  read_rules(R"("a": {"wears": {"top": {"dress": 1, "t_shirt": 1}, "hair": {"short_hair": 1}}})");
  for (std::uint32_t agent = 0; agent < 20; ++agent) {
    const Dressed dressed = dress({.agent = agent, .body = 1});
    const std::vector<std::string> worn = names(dressed);
    const bool is_dress = std::ranges::find(worn, "dress") != worn.end();
    EXPECT_EQ(part_of_piece(wardrobe_, dressed.outfit.silhouette).name,
              is_dress ? "silhouette/skirt/short" : "silhouette/trousers/short");
  }
}

TEST_F(Dressing, ColoursSilhouettesAsWhatIsSeenOfTheOutfit) {
  read_rules(
      R"("a": {"wears": {"top": {"dress": 1, "t_shirt": 1}, "bottom": {"jeans": 1}, "outer": {"coat": 1, "none": 1}}})");
  const auto tint = [&](render::Region region) { return look_.tints[static_cast<std::size_t>(region)]; };
  int coats = 0, dresses = 0;
  for (std::uint32_t agent = 0; agent < 60; ++agent) {
    look_ = {};
    const std::vector<std::string> worn = names(dress({.agent = agent, .body = 1}));
    const bool coat = std::ranges::find(worn, "coat") != worn.end();
    const bool dress = std::ranges::find(worn, "dress") != worn.end();
    EXPECT_EQ(tint(render::Region::outer) == tint(render::Region::top), !coat);
    EXPECT_EQ(tint(render::Region::bottom) == tint(render::Region::top), dress);
    coats += coat ? 1 : 0;
    dresses += dress ? 1 : 0;
  }
  EXPECT_GT(coats, 10);
  EXPECT_GT(dresses, 10);
}

TEST_F(Dressing, TakesTheSilhouetteBeforeWhereAWardrobeHasNoneOfACut) {
  read_rules(R"("a": {"wears": {"top": {"t_shirt": 1}, "outer": {"coat": 1}}})");
  EXPECT_EQ(part_of_piece(wardrobe_, dress({}).outfit.silhouette).name, "silhouette/skirt/short") << "for a coat";
}

TEST_F(Dressing, ColoursClothesAsTheirRuleSays) {
  read_rules(R"("a": {"wears": {"top": {"t_shirt": 1}}})");
  dress({});
  const auto top = static_cast<std::size_t>(render::Region::top);
  EXPECT_EQ(look_.tints[top] >> 24U, 5U | 2U << 5U) << "dots of wool";
  EXPECT_GT(look_.tints[top] & 0xFFU, 0xD0U) << "red";
  EXPECT_EQ(look_.tints[top] & 0xFFFF00U, 0U);
  EXPECT_EQ(look_.seconds[top] & 0xFFFFFFU, 0xFF0000U) << "blue";
}

TEST_F(Dressing, GivesTeamsTheirColours) {
  read_rules(R"("a": {"alike": true, "wears": {"top": {"t_shirt": 1}}, "colours": {"top": "team"}})");
  const auto top = static_cast<std::size_t>(render::Region::top);
  for (std::uint32_t agent = 0; agent < 20; ++agent) {
    dress({.agent = agent, .team = agent % 2});
    EXPECT_EQ(look_.tints[top] & 0xFFFFFFU, agent % 2 == 0 ? 0x111111U : 0x333333U);
    EXPECT_EQ(look_.seconds[top] & 0xFFFFFFU, agent % 2 == 0 ? 0x222222U : 0x444444U);
  }
}

TEST_F(Dressing, GivesAllTheSameUniformButTheirOwnHair) {
  read_rules(R"("a": {"alike": true, "wears": {"top": {"t_shirt": 1, "none": 1}, "bottom": {"jeans": 1, "none": 1},
                                               "hair": {"short_hair": 1, "none": 1}}})");
  std::set<std::vector<std::string>> clothes;
  for (std::uint32_t agent = 0; agent < 40; ++agent) clothes.insert(names(dress({.agent = agent})));
  EXPECT_EQ(clothes.size(), 2U) << "with hair and without";
}

TEST_F(Dressing, GivesUniformsTheSameColoursWhateverElseIsWorn) {
  read_rules(R"("a": {"alike": true, "wears": {"top": {"dress": 1, "t_shirt": 0}, "bottom": {"jeans": 1},
                                               "headgear": {"helmet": 1}}})");
  Palette shades{"shades", {}};
  for (std::uint32_t shade = 1; shade <= 40; ++shade) shades.colors.push_back(shade);
  rules_.palettes.push_back(shades);
  rules_.styles.front().colors = {{"headgear", "shades"}};
  const auto hat = static_cast<std::size_t>(render::Region::headgear);
  for (std::uint32_t team = 0; team < 8; ++team) {
    dress({.body = 0, .team = team});
    const std::uint32_t with_jeans = look_.tints[hat];
    dress({.body = 1, .team = team});
    EXPECT_EQ(look_.tints[hat], with_jeans) << "with a dress";
  }
}

TEST_F(Dressing, DressesACompanyThatMarchesInOneStyleOfItsOwn) {
  read_rules(R"("a": {"wears": {"top": {"t_shirt": 1}}}, "b": {"wears": {"bottom": {"jeans": 1}}},
                "c": {"wears": {"headgear": {"helmet": 1}}})");
  rules_.scenes.push_back({std::string(marching_scene), {{"b", 1.0F}, {"c", 1.0F}}});
  std::set<std::string> styles;
  for (std::uint32_t company = 0; company < 12; ++company) {
    std::set<std::string> in_company;
    for (std::uint32_t agent = 0; agent < 20; ++agent) {
      in_company.insert(
          dress({.agent = 20 * company + agent, .group = company, .team = company, .marches = true}).style->name);
    }
    EXPECT_EQ(in_company.size(), 1U);
    styles.merge(in_company);
  }
  EXPECT_THAT(styles, UnorderedElementsAre("b", "c"));
  EXPECT_EQ(dress({}).style->name, "a") << "who does not march";
}

TEST_F(Dressing, GoesByTheWeather) {
  read_rules(R"("a": {"wears": {"hand_right": {"umbrella": 1, "none": 1}}})",
             R"("weather": {"rain": {"rain": 1000}},)");
  weather_ = "rain";
  int umbrellas = 0;
  for (std::uint32_t agent = 0; agent < 100; ++agent) umbrellas += dress({.agent = agent}).in_hand != nullptr ? 1 : 0;
  EXPECT_GT(umbrellas, 95);
}

TEST_F(Dressing, IsTheSameForTheSamePersonAndAnotherForAnotherAttempt) {
  read_rules(R"("a": {"wears": {"top": {"t_shirt": 1, "none": 1}, "bottom": {"jeans": 1, "none": 1},
                                "hair": {"short_hair": 1, "none": 1}, "hand_right": {"umbrella": 1, "none": 1}}})");
  const Dressed first = dress({.agent = 5});
  EXPECT_EQ(dress({.agent = 5}).outfit, first.outfit);
  EXPECT_EQ(dress({.agent = 5}).looks_like, first.looks_like);
  bool differs = false;
  for (std::uint32_t attempt = 1; attempt < 8; ++attempt) {
    differs |= dress({.agent = 5}, attempt).looks_like != first.looks_like;
  }
  EXPECT_TRUE(differs);
}

}  // namespace
}  // namespace throng::app::dresser_test
