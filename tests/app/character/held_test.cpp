#include "app/character/held.h"

#include <gtest/gtest.h>

namespace throng::app::held_test {
namespace {

constexpr std::array all_held{Held::nothing, Held::bag,      Held::briefcase, Held::umbrella, Held::phone,
                              Held::cup,     Held::stick,    Held::balloon,   Held::flag,     Held::camera,
                              Held::child,   Held::grown_up, Held::pushchair};

TEST(Held, IsKnownByTheNamesOfParts) {
  EXPECT_EQ(held_named("tote"), Held::bag);
  EXPECT_EQ(held_named("stick"), Held::stick);
  EXPECT_EQ(held_named("backpack"), Held::nothing) << "it hangs on the back";
  EXPECT_EQ(held_named(""), Held::nothing);
}

TEST(Held, HasAnArmThatHoldsItAllButNothing) {
  static_assert(all_held.size() == held_count);
  for (const Held held : all_held) EXPECT_EQ(arm_of(held).has_value(), held != Held::nothing) << static_cast<int>(held);
}

TEST(Held, IsWhatTheWholeBodyUsesInItsOwnRoleAlone) {
  EXPECT_TRUE(can_do(Held::cup, Role::drink));
  EXPECT_FALSE(can_do(Held::nothing, Role::drink));
  EXPECT_FALSE(can_do(Held::bag, Role::phone));
  EXPECT_TRUE(is_in_hand(Held::phone, Role::call));
  EXPECT_FALSE(arm_lies_over(Held::phone, Role::call)) << "that clip moves the arm itself";
}

TEST(Held, LetsNobodyDoWhatTakesTheHandThatHoldsIt) {
  EXPECT_FALSE(can_do(Held::umbrella, Role::wave));
  EXPECT_TRUE(can_do(Held::flag, Role::cheer));
  EXPECT_FALSE(can_do(Held::flag, Role::clap));
  EXPECT_FALSE(can_do(Held::pushchair, Role::run));
  EXPECT_TRUE(can_do(Held::bag, Role::run));
  for (const Held held : all_held) EXPECT_TRUE(can_do(held, Role::walk));
}

TEST(Held, IsPutAwayWhileSomebodySits) {
  EXPECT_FALSE(is_in_hand(Held::bag, Role::sit));
  EXPECT_TRUE(is_in_hand(Held::balloon, Role::sit));
  EXPECT_TRUE(is_in_hand(Held::phone, Role::sit)) << "they look at it on a bench";
  EXPECT_TRUE(is_in_hand(Held::bag, Role::lean));
  EXPECT_FALSE(is_in_hand(Held::stick, Role::lean));
  EXPECT_TRUE(is_in_hand(Held::bag, Role::stand));
}

}  // namespace
}  // namespace throng::app::held_test
