#include "engine/anim/agent/character_rigs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/synthetic_model.h"
#include "tests/anim/agent/person_crowd.h"
#include "tests/anim/asset/clip_fixtures.h"

namespace throng::anim::character_rigs_test {
namespace {

using Limb = CharacterRigs::Limb;
using testing::Contains;
using testing::HasSubstr;

TEST(CharacterRigs, FindAllOfAPerson) {
  const CharacterRigs& rigs = person_rigs();
  EXPECT_TRUE(rigs.look_at().has_value());
  ASSERT_TRUE(rigs.foot_placement().has_value());
  EXPECT_EQ(rigs.foot_placement()->leg_count, 2);
  EXPECT_TRUE(rigs.ragdoll().has_value());
  for (const Limb limb : {Limb::left_arm, Limb::right_arm, Limb::left_leg, Limb::right_leg}) {
    EXPECT_TRUE(rigs.limb(limb).has_value());
  }
  EXPECT_TRUE(rigs.missing().empty()) << rigs.missing().front();
}

TEST(CharacterRigs, SayWhyWhatACharacterLacksIsNotThere) {
  const CharacterRigs rigs(one_bone_model());
  EXPECT_FALSE(rigs.look_at().has_value());
  EXPECT_FALSE(rigs.foot_placement().has_value());
  EXPECT_FALSE(rigs.ragdoll().has_value());
  EXPECT_FALSE(rigs.limb(Limb::left_arm).has_value());
  EXPECT_THAT(rigs.missing(), Contains(HasSubstr("no bone is its head for certain")));
  EXPECT_THAT(rigs.missing(), Contains(HasSubstr("cannot be placed on 0 legs")));
}

TEST(CharacterRigs, AreRefusedForSkeletonsThatScale) {
  const CharacterRigs rigs(general_model(20));
  EXPECT_FALSE(rigs.look_at().has_value());
  EXPECT_FALSE(rigs.foot_placement().has_value());
  EXPECT_FALSE(rigs.ragdoll().has_value());
  EXPECT_GE(rigs.missing().size(), 3U);
}

TEST(CharacterRigs, GiveASystemOnlyTheKindsThatTheCharacterHas) {
  const auto character = std::make_shared<const Character>(bake_character(one_bone_model()));
  const CharacterRigs rigs(one_bone_model());
  const auto system = std::move(*AnimationSystem::create(character, {}));
  const RigKinds kinds = rigs.add_to(*system);
  EXPECT_FALSE(kinds.look_at || kinds.foot_placement || kinds.limbs || kinds.ragdoll);
  EXPECT_EQ(system->characters().pools(0).kind_count(), EntityPools::usual_kinds);
  PersonCrowd people;
  EXPECT_EQ(people.system().characters().pools(0).kind_count(), EntityPools::usual_kinds + 4U);
}

}  // namespace
}  // namespace throng::anim::character_rigs_test
