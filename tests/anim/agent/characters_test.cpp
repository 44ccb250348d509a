// What the agents of a character share, each character for itself.

#include <memory>
#include <numeric>
#include <utility>

#include <gtest/gtest.h>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/agent/simple_channel.h"
#include "engine/anim/asset/bone_priorities.h"
#include "engine/anim/asset/synthetic_model.h"
#include "tests/anim/agent/heard_misuses.h"

namespace throng::anim::characters_test {
namespace {

std::shared_ptr<const Character> character_of(int bones) {
  return std::make_shared<const Character>(bake_character(synthetic_model(bones, 2)));
}

std::unique_ptr<AnimationSystem> two_characters(const SystemOptions& options = {}) {
  auto system = std::move(*AnimationSystem::create(character_of(30), options));
  EXPECT_EQ(system->characters().add(character_of(12))->number, 1U);
  return system;
}

TEST(Characters, AreNumberedInTheOrderInWhichTheyCome) {
  const auto system = two_characters();
  EXPECT_EQ(system->characters().count(), 2U);
  EXPECT_EQ(system->characters()[0].skeleton.bone_count(), 30);
  EXPECT_EQ(system->characters()[1].skeleton.bone_count(), 12);
  system->add_agents(3, 1);
  EXPECT_EQ(system->agent(2).character_number(), 1U);
}

TEST(Characters, ThatDoNotFitTheStoresAreRefusedWithoutATrace) {
  const auto system = two_characters({.local_store_bytes = 16 * 1024});
  const auto added = system->characters().add(character_of(900));
  ASSERT_FALSE(added.has_value());
  EXPECT_FALSE(added.error().message.empty());
  EXPECT_EQ(system->characters().count(), 2U);
}

TEST(Characters, CountTheirMasksApart) {
  const auto system = two_characters();
  const SubtreeWeight all{.bone = 0};
  const auto add = [&](std::uint32_t character) {
    return system->characters().add_mask(BoneMask("all", system->characters()[character].skeleton, {&all, 1}),
                                         character);
  };
  EXPECT_EQ(add(0), 0);
  EXPECT_EQ(add(0), 1);
  EXPECT_EQ(add(1), 0);
}

TEST(Characters, KeepTheirOrderOfBonesWhileASelectionDependsOnIt) {
  const auto system = two_characters();
  const std::vector<std::uint8_t> priorities(12, 1);
  system->characters().add_bone_selection(BoneSelection(system->characters()[1].skeleton, priorities, 1), 1);
  std::vector<int> places(12);
  std::iota(places.begin(), places.end(), 0);
  const std::shared_ptr<const Character> again = character_of(12);
  EXPECT_TRUE(system->characters().replace(1, again, places)) << "other levels in the same order";
  std::swap(places[10], places[11]);
  const Status refused = system->characters().replace(1, again, places);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("selections of bones"), std::string::npos);
  EXPECT_EQ(&system->characters()[1], again.get());
}

TEST(Characters, RefusePlacesOfBonesOfWhichTwoAreTheSame) {
  const auto system = two_characters();
  std::vector<int> places(12);
  std::iota(places.begin(), places.end(), 0);
  places[10] = 11;
  const HeardMisuses heard;
  EXPECT_FALSE(system->characters().replace(1, character_of(12), places));
  EXPECT_EQ(HeardMisuses::all().size(), 1U);
}

TEST(Characters, HaveSharedEntitiesInPoolsOfTheirOwn) {
  const auto system = two_characters();
  const auto shared = system->characters().add_shared(std::make_unique<SimpleChannel>(PlayerStart{.clip = 1}), 1);
  ASSERT_TRUE(shared.has_value());
  EXPECT_TRUE(system->characters().pools(1).alive(*shared));
  const auto players_of = [&](std::uint32_t character) {
    return system->characters().pools(character).shared_pool(EntityPools::sampled_players).alive_count();
  };
  EXPECT_EQ(players_of(0), 0U);
  EXPECT_EQ(players_of(1), 1U);
}

}  // namespace
}  // namespace throng::anim::characters_test
