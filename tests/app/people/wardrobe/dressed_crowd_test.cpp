#include "app/people/wardrobe/dressed_crowd.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/character/built_in.h"
#include "app/people/wardrobe/clothing.h"
#include "tests/app/people/wardrobe/part_of_piece.h"

namespace throng::app::dressed_crowd_test {
namespace {

/// A crowd of the built-in character, dressed by the rules that come with the program.
class DressedCrowdTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto source = load_built_in("", {.wardrobe = true});
    ASSERT_TRUE(source) << source.error().message;
    auto clothing = clothing_of(*source);
    ASSERT_TRUE(clothing) << clothing.error().message;
    roles_ = source->roles;
    roles_.bodies = body_kinds(clothing->rules);
    clothing_ = std::move(*clothing);
  }

  static Tuning tuning_of(Scene scene, int agents, Weather weather = Weather::mild) {
    Tuning tuning;
    tuning.scene = scene;
    tuning.agents = agents;
    tuning.wardrobe = true;
    tuning.weather = weather;
    return tuning;
  }

  static Crowd crowd_of(const Tuning& tuning) {
    return Crowd(tuning.scene, static_cast<std::size_t>(tuning.agents), tuning.seed, std::span(&roles_, 1),
                 variety_of(tuning));
  }

  /// Returns the names of what an agent wears over skin, hair and face.
  static std::set<std::string> clothes(const DressedCrowd& dressed, std::size_t agent) {
    std::set<std::string> names;
    const render::Outfit& outfit = dressed.outfits[agent];
    for (std::size_t i = 0; i < outfit.count; ++i) {
      const WardrobePart& part = part_of_piece(clothing_.wardrobe, outfit.pieces.at(i));
      const bool is_skin = std::ranges::find(clothing_.rules.skin, part.slot) != clothing_.rules.skin.end();
      if (!is_skin && part.slot != "hair" && part.slot != "face") names.insert(part.name);
    }
    return names;
  }

  /// Returns the names of what people are told apart by.
  static std::set<std::string> seen_first(const DressedCrowd& dressed, std::size_t agent) {
    std::set<std::string> names;
    const render::Outfit& outfit = dressed.outfits[agent];
    for (std::size_t i = 0; i < outfit.count; ++i) {
      const WardrobePart& part = part_of_piece(clothing_.wardrobe, outfit.pieces.at(i));
      const bool counts =
          part.slot == "top" || part.slot == "bottom" || part.slot == "outer" || part.slot == "headgear";
      if (counts) names.insert(part.slot + " " + part.name);
    }
    return names;
  }

  /// Says whether two who wear the same have the same patterns in colours that one cannot tell apart.
  static bool same_colors(const render::AgentLook& one, const render::AgentLook& other,
                          const std::set<std::string>& worn) {
    constexpr int most_apart = 10;  // of 255, in one channel
    for (const auto& [slot, region] :
         {std::pair{"top ", render::Region::top}, std::pair{"bottom ", render::Region::bottom},
          std::pair{"outer ", render::Region::outer}}) {
      const auto at = static_cast<std::size_t>(region);
      if (std::ranges::none_of(worn, [&](const std::string& name) { return name.starts_with(slot); })) continue;
      if ((one.tints[at] ^ other.tints[at]) >> 24U != 0) return false;
      for (const unsigned shift : {0U, 8U, 16U}) {
        const int a = static_cast<int>(one.tints[at] >> shift & 0xFFU);
        const int b = static_cast<int>(other.tints[at] >> shift & 0xFFU);
        if (std::abs(a - b) > most_apart) return false;
      }
    }
    return true;
  }

  /// Returns all pairs who have the same body and clothes, in the same patterns and colours, wherever they are.
  static std::vector<std::pair<std::size_t, std::size_t>> alike(const Crowd& crowd, const DressedCrowd& dressed) {
    std::map<std::pair<std::uint8_t, std::set<std::string>>, std::vector<std::size_t>> classes;
    for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
      classes[{crowd.looks().bodies[agent], seen_first(dressed, agent)}].push_back(agent);
    }
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (const auto& [shown, agents] : classes) {
      for (std::size_t one = 0; one < agents.size(); ++one) {
        for (std::size_t other = one + 1; other < agents.size(); ++other) {
          if (!same_colors(dressed.looks[agents[one]], dressed.looks[agents[other]], shown.second)) continue;
          pairs.emplace_back(agents[one], agents[other]);
        }
      }
    }
    return pairs;
  }

  static CharacterRoles roles_;
  static Clothing clothing_;
};
CharacterRoles DressedCrowdTest::roles_;
Clothing DressedCrowdTest::clothing_;

TEST_F(DressedCrowdTest, GivesCamerasToWhoTakesPicturesAndNoPushchairsToWhoSits) {
  const Tuning tuning = tuning_of(Scene::plaza, 1000);
  const Crowd crowd = crowd_of(tuning);
  const DressedCrowd dressed = dress_crowd(crowd, std::span(&clothing_, 1), tuning);
  int cameras = 0, seated = 0;
  for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
    const Habit habit = crowd.minds().habits()[agent];
    if (habit == Habit::photograph) {
      EXPECT_EQ(dressed.things[agent], HeldThing::camera);
      ++cameras;
    }
    if (habit == Habit::rest || habit == Habit::lean || habit == Habit::sit_low) {
      EXPECT_NE(dressed.things[agent], HeldThing::pushchair);
      ++seated;
    }
  }
  EXPECT_GT(cameras, 8);
  EXPECT_GT(seated, 20);
}

TEST_F(DressedCrowdTest, ShowsNoTwoAlikeNearEachOther) {
  const Tuning tuning = tuning_of(Scene::plaza, 1000);
  const Crowd crowd = crowd_of(tuning);
  const DressedCrowd dressed = dress_crowd(crowd, {&clothing_, 1}, tuning);
  for (const auto& [one, other] : alike(crowd, dressed)) {
    EXPECT_GE(glm::distance(crowd.positions()[one], crowd.positions()[other]), alike_reach) << one << " " << other;
  }
}

TEST_F(DressedCrowdTest, SeldomShowsTheSameAboveTheWaistSideBySide) {
  const Tuning tuning = tuning_of(Scene::plaza, 1000);
  const Crowd crowd = crowd_of(tuning);
  const DressedCrowd dressed = dress_crowd(crowd, {&clothing_, 1}, tuning);
  const auto upper = [&](std::size_t agent) {
    std::set<std::string> names = seen_first(dressed, agent);
    std::erase_if(names,
                  [](const std::string& name) { return !name.starts_with("top ") && !name.starts_with("outer "); });
    return names;
  };
  int same = 0;
  for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
    for (std::size_t other = agent + 1; other < crowd.size(); ++other) {
      if (glm::distance(crowd.positions()[agent], crowd.positions()[other]) >= upper_alike_reach) continue;
      const bool is_same =
          upper(agent) == upper(other) && same_colors(dressed.looks[agent], dressed.looks[other], upper(agent));
      same += is_same ? 1 : 0;
    }
  }
  EXPECT_LT(same, 4) << "pairs of a thousand people";
}

TEST_F(DressedCrowdTest, LetsNobodyMeetSomebodyAlikeInAMinute) {
  const Tuning tuning = tuning_of(Scene::plaza, 1000);
  Crowd crowd = crowd_of(tuning);
  const DressedCrowd dressed = dress_crowd(crowd, {&clothing_, 1}, tuning);
  const auto pairs = alike(crowd, dressed);
  constexpr int minute = 60, frames_a_second = 30;
  int met = 0;
  for (int frame = 0; frame < minute * frames_a_second; ++frame) {
    crowd.advance(ticks_per_second / frames_a_second);
    for (const auto& [one, other] : pairs) {
      met += glm::distance(crowd.positions()[one], crowd.positions()[other]) < alike_reach ? 1 : 0;
    }
  }
  std::string who;
  for (const auto& [one, other] : pairs) {
    who += "; " + std::to_string(one) + " and " + std::to_string(other) + " in";
    for (const std::string& name : seen_first(dressed, one)) who += " " + name;
  }
  EXPECT_EQ(met, 0) << "pairs and frames, of " << pairs.size() << " pairs who look alike" << who;
}

TEST_F(DressedCrowdTest, HasManySilhouettes) {
  const Tuning tuning = tuning_of(Scene::plaza, 1000);
  const Crowd crowd = crowd_of(tuning);
  const DressedCrowd dressed = dress_crowd(crowd, {&clothing_, 1}, tuning);
  std::map<std::set<std::string>, int> outfits;
  for (std::size_t agent = 0; agent < crowd.size(); ++agent) ++outfits[clothes(dressed, agent)];
  EXPECT_GT(outfits.size(), 300U) << "of a thousand people";
  for (const auto& [names, people] : outfits) EXPECT_LT(people, 40);
}

TEST_F(DressedCrowdTest, GivesEverybodyAFaceOfTheirOwn) {
  const Tuning tuning = tuning_of(Scene::plaza, 300);
  const DressedCrowd dressed = dress_crowd(crowd_of(tuning), {&clothing_, 1}, tuning);
  std::set<std::uint32_t> faces;
  for (const render::AgentLook& look : dressed.looks) faces.insert(look.face);
  EXPECT_GT(faces.size(), 290U);
}

TEST_F(DressedCrowdTest, DressesTheCompaniesOfAParadeAlikeAndEachInItsWay) {
  const Tuning tuning = tuning_of(Scene::parade, 1000);
  const Crowd crowd = crowd_of(tuning);
  const DressedCrowd dressed = dress_crowd(crowd, {&clothing_, 1}, tuning);
  std::map<std::uint32_t, std::set<std::set<std::string>>> clothes_of;
  for (std::size_t marcher = 0; marcher < crowd.marchers().count(); ++marcher) {
    clothes_of[crowd.marchers().company(marcher)].insert(clothes(dressed, crowd.walkers().count() + marcher));
  }
  ASSERT_GT(clothes_of.size(), 6U);
  std::set<std::set<std::set<std::string>>> ways;
  int uniforms = 0;
  for (const auto& [company, outfits] : clothes_of) {
    ways.insert(outfits);
    uniforms += outfits.size() <= 2 ? 1 : 0;
  }
  EXPECT_GE(ways.size(), 4U);
  EXPECT_GE(uniforms, 5) << "men and women may have another cut";
}

TEST_F(DressedCrowdTest, LeavesNobodyWithoutClothes) {
  for (const Weather weather : {Weather::mild, Weather::warm, Weather::cold, Weather::rain}) {
    for (const Scene scene : {Scene::plaza, Scene::stadium, Scene::parade}) {
      const Tuning tuning = tuning_of(scene, 500, weather);
      const Crowd crowd = crowd_of(tuning);
      const DressedCrowd dressed = dress_crowd(crowd, {&clothing_, 1}, tuning);
      for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
        std::set<std::string> slots;
        for (const std::string& name : clothes(dressed, agent)) {
          for (const WardrobePart& part : clothing_.wardrobe.parts()) {
            if (part.name == name) slots.insert(part.slot);
          }
        }
        EXPECT_TRUE(slots.contains("top"));
        EXPECT_TRUE(slots.contains("shoes"));
        const bool is_dress = std::ranges::any_of(clothing_.wardrobe.parts(), [&](const WardrobePart& part) {
          return clothes(dressed, agent).contains(part.name) &&
                 std::ranges::find(part.keeps_out, "bottom") != part.keeps_out.end();
        });
        EXPECT_TRUE(is_dress || slots.contains("bottom"));
      }
    }
  }
}

TEST_F(DressedCrowdTest, ShowsSkirtsFromAfar) {
  const Tuning tuning = tuning_of(Scene::plaza, 1000);
  const Crowd crowd = crowd_of(tuning);
  const DressedCrowd dressed = dress_crowd(crowd, {&clothing_, 1}, tuning);
  int skirts = 0;
  for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
    EXPECT_LT(dressed.outfits[agent].count, render::Outfit::most_pieces) << "nothing is left out";
    const std::string silhouette = part_of_piece(clothing_.wardrobe, dressed.outfits[agent].silhouette).name;
    if (!clothes(dressed, agent).contains("knee_skirt")) continue;
    ++skirts;
    const std::string cut = clothes(dressed, agent).contains("coat") ? "coat" : "skirt";
    EXPECT_EQ(silhouette.find("silhouette/" + cut + "/"), 0U) << silhouette;
  }
  EXPECT_GT(skirts, 10);
}

TEST_F(DressedCrowdTest, LeadsChildrenByTheHand) {
  const Tuning tuning = tuning_of(Scene::plaza, 1000);
  const Crowd crowd = crowd_of(tuning);
  const DressedCrowd dressed = dress_crowd(crowd, {&clothing_, 1}, tuning);
  int led = 0;
  for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
    if (dressed.things[agent] != HeldThing::grown_up) continue;
    ++led;
    EXPECT_TRUE(is_child(crowd, agent));
    EXPECT_EQ(dressed.things[agent - 1], HeldThing::child);
    EXPECT_LT(glm::distance(crowd.positions()[agent], crowd.positions()[agent - 1]), 1.0F);
  }
  EXPECT_GT(led, 5);
}

TEST_F(DressedCrowdTest, WearsByRulesThatNobodyDoubts) {
  EXPECT_THAT(clothing_.doubts, testing::IsEmpty());
  EXPECT_THAT(clothing_.origin, testing::EndsWith("cast.json"));
}

TEST_F(DressedCrowdTest, IsTheSameForTheSameSeed) {
  const Tuning tuning = tuning_of(Scene::plaza, 300);
  const Crowd crowd = crowd_of(tuning);
  const DressedCrowd one = dress_crowd(crowd, {&clothing_, 1}, tuning),
                     two = dress_crowd(crowd, {&clothing_, 1}, tuning);
  EXPECT_EQ(one.looks, two.looks);
  EXPECT_EQ(one.outfits, two.outfits);
  EXPECT_EQ(one.things, two.things);
}

}  // namespace
}  // namespace throng::app::dressed_crowd_test
