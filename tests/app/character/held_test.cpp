#include "app/character/held.h"

#include <gtest/gtest.h>

namespace throng::app::held_test {
namespace {

constexpr std::array all_held{HeldThing::nothing,  HeldThing::bag,    HeldThing::briefcase, HeldThing::umbrella,
                              HeldThing::phone,    HeldThing::cup,    HeldThing::stick,     HeldThing::balloon,
                              HeldThing::flag,     HeldThing::camera, HeldThing::child,     HeldThing::grown_up,
                              HeldThing::pushchair};

TEST(HeldThing, IsKnownByTheNamesOfParts) {
  EXPECT_EQ(held_named("tote"), HeldThing::bag);
  EXPECT_EQ(held_named("stick"), HeldThing::stick);
  EXPECT_EQ(held_named("backpack"), HeldThing::nothing) << "it hangs on the back";
  EXPECT_EQ(held_named(""), HeldThing::nothing);
}

TEST(HeldThing, HasAnArmThatHoldsItAllButNothing) {
  static_assert(all_held.size() == held_count);
  for (const HeldThing held : all_held)
    EXPECT_EQ(arm_of(held).has_value(), held != HeldThing::nothing) << static_cast<int>(held);
}

TEST(HeldThing, IsWhatTheWholeBodyUsesInItsOwnRoleAlone) {
  EXPECT_TRUE(allows_role(HeldThing::cup, Role::drink));
  EXPECT_FALSE(allows_role(HeldThing::nothing, Role::drink));
  EXPECT_FALSE(allows_role(HeldThing::bag, Role::phone));
  EXPECT_TRUE(is_drawn_in_role(HeldThing::phone, Role::call));
  EXPECT_FALSE(arm_lies_over(HeldThing::phone, Role::call)) << "that clip moves the arm itself";
}

TEST(HeldThing, LetsNobodyDoWhatTakesTheHandThatHoldsIt) {
  EXPECT_FALSE(allows_role(HeldThing::umbrella, Role::wave));
  EXPECT_TRUE(allows_role(HeldThing::flag, Role::cheer));
  EXPECT_FALSE(allows_role(HeldThing::flag, Role::clap));
  EXPECT_FALSE(allows_role(HeldThing::pushchair, Role::run));
  EXPECT_TRUE(allows_role(HeldThing::bag, Role::run));
  for (const HeldThing held : all_held) EXPECT_TRUE(allows_role(held, Role::walk));
}

TEST(HeldThing, IsPutAwayWhileSomebodySits) {
  EXPECT_FALSE(is_drawn_in_role(HeldThing::bag, Role::sit));
  EXPECT_TRUE(is_drawn_in_role(HeldThing::balloon, Role::sit));
  EXPECT_TRUE(is_drawn_in_role(HeldThing::phone, Role::sit)) << "they look at it on a bench";
  EXPECT_TRUE(is_drawn_in_role(HeldThing::bag, Role::lean));
  EXPECT_FALSE(is_drawn_in_role(HeldThing::stick, Role::lean));
  EXPECT_TRUE(is_drawn_in_role(HeldThing::bag, Role::stand));
}

}  // namespace
}  // namespace throng::app::held_test
