#include "app/character/roles.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::app::roles_test {
namespace {

using Names = std::vector<std::string>;

std::string clip_for(Role role, const Names& names) {
  const int clip = roles_by_name(names).clip(role);
  return clip == no_clip ? "none" : names.at(static_cast<std::size_t>(clip));
}

TEST(RolesByName, AreFoundWhateverTheCaseAndThePrefix) {
  const Names names{"CharacterArmature|Death", "CharacterArmature|Idle",     "CharacterArmature|WALK",
                    "CharacterArmature|Wave",  "CharacterArmature|cheering", "CharacterArmature|Clapping"};
  EXPECT_EQ(clip_for(Role::stand, names), names[1]);
  EXPECT_EQ(clip_for(Role::walk, names), names[2]);
  EXPECT_EQ(clip_for(Role::wave, names), names[3]);
  EXPECT_EQ(clip_for(Role::cheer, names), names[4]);
  EXPECT_EQ(clip_for(Role::clap, names), names[5]);
}

TEST(RolesByName, ThePlainestNameWins) {
  const Names names{"2H_Melee_Idle", "Jump_Idle",         "Lie_Idle",  "Unarmed_Idle", "Idle",
                    "Running_A",     "Walking_Backwards", "Walking_A", "Walking_B",    "Cheer"};
  EXPECT_EQ(clip_for(Role::stand, names), "Idle");
  EXPECT_EQ(clip_for(Role::walk, names), "Walking_A");
  EXPECT_EQ(clip_for(Role::cheer, names), "Cheer");
}

TEST(RolesByName, WordsMayRunTogether) {
  const Names names{"Robot_WalkJump", "Robot_Standing", "Robot_Idle", "Robot_Walking", "Robot_Dance", "Robot_Jump"};
  EXPECT_EQ(clip_for(Role::stand, names), "Robot_Idle");
  EXPECT_EQ(clip_for(Role::walk, names), "Robot_Walking");
  EXPECT_EQ(clip_for(Role::cheer, names), "Robot_Dance");
}

TEST(RolesByName, ARunStandsInForAWalkAndAJumpForACheer) {
  const Names names{"Idle", "Run_Back", "Run", "Jump_Land", "Jump"};
  EXPECT_EQ(clip_for(Role::walk, names), "Run");
  EXPECT_EQ(clip_for(Role::cheer, names), "Jump");
}

TEST(RolesByName, EachGaitHasItsOwnAndNoneIsTwoOfThem) {
  const Names all{"Idle", "Walk", "Jog", "Run"}, two{"Walking_A", "Running_A", "Running_Strafe_Left"}, one{"Run"};
  EXPECT_EQ(clip_for(Role::walk, all), "Walk");
  EXPECT_EQ(clip_for(Role::jog, all), "Jog");
  EXPECT_EQ(clip_for(Role::run, all), "Run");
  EXPECT_EQ(clip_for(Role::jog, two), "none");
  EXPECT_EQ(clip_for(Role::run, two), "Running_A");
  EXPECT_EQ(clip_for(Role::walk, one), "Run");
  EXPECT_EQ(clip_for(Role::run, one), "none");
}

TEST(RolesByName, StepsAsideAndBackAreFoundAsArtistsNameThem) {
  struct Case {
    Role role;
    const char* name;
  };
  for (const auto& [role, name] :
       {Case{Role::walk_back, "Walking_Backwards"}, Case{Role::walk_back, "Walk_Back"},
        Case{Role::walk_back, "Armature|walk back"}, Case{Role::walk_back, "Jog_Bwd_Loop"},
        Case{Role::step_left, "Strafe_Left"}, Case{Role::step_left, "StepLeft"}, Case{Role::step_left, "step left"},
        Case{Role::step_left, "Left Strafe Walking"}, Case{Role::step_left, "StrafeL"},
        Case{Role::step_left, "SideStep_Left"}, Case{Role::step_right, "Running_Strafe_Right"},
        Case{Role::step_right, "Walk_R"}, Case{Role::step_right, "StepRight"}, Case{Role::shuffle, "Shuffle"},
        Case{Role::shuffle, "Slow_Walk"}, Case{Role::step_in_place, "March_In_Place"},
        Case{Role::step_in_place, "step in place"}, Case{Role::veer_left, "Walk_Fwd_Left"},
        Case{Role::veer_right, "veer right"}}) {
    const CharacterRoles roles = roles_by_name(Names{"Idle", "Walking_A", name});
    EXPECT_EQ(roles.clip(role), 2) << name;
    EXPECT_EQ(roles.clip(Role::walk), 1) << name;
    EXPECT_EQ(std::ranges::count(roles.clips, 2), 1) << name << " has one role";
  }
}

TEST(RolesByName, OtherThingsToTheLeftAndBackAreNoSteps) {
  for (const char* const name :
       {"turn left", "Turn_Left_Walk", "Left Turn", "Wave_Left", "Jump_Back", "Backflip", "Walk_Back_Left_Start",
        "Strafe_Left_Stop", "Crouch_Walk_Left", "Step_Back_Dodge", "Shuffle_Dance", "LeftHandOut", "Slow_Run"}) {
    const CharacterRoles roles = roles_by_name(Names{"Idle", "Walk", name});
    for (const Role role : {Role::walk_back, Role::step_left, Role::step_right, Role::shuffle}) {
      EXPECT_EQ(roles.clip(role), no_clip) << name << " is " << role_names.at(index_of(role));
    }
  }
}

TEST(RolesByName, ASlowWalkThatIsTheOnlyWalkIsNoShuffle) {
  EXPECT_EQ(clip_for(Role::walk, {"Idle", "Slow_Walk"}), "Slow_Walk");
  EXPECT_EQ(clip_for(Role::shuffle, {"Idle", "Slow_Walk"}), "none");
}

TEST(RolesByName, SittingIsNotSittingDown) {
  const Names names{"Sit_Chair_Down", "Sit_Chair_Idle", "Sit_Chair_Pose", "Sit_Chair_StandUp", "Look_Around"};
  EXPECT_EQ(clip_for(Role::sit, names), "Sit_Chair_Idle");
  EXPECT_EQ(clip_for(Role::look_around, names), "Look_Around");
}

TEST(RolesByName, HaveNamesOfTheirOwn) {
  for (std::size_t role = 0; role < role_count; ++role) {
    EXPECT_EQ(role_named(role_names.at(role)), static_cast<Role>(role));
  }
  EXPECT_EQ(role_named("other"), std::nullopt);
  EXPECT_EQ(known_roles(),
            "stand, look_around, walk, jog, run, wave, cheer, clap, sit, walk_back, step_left, step_right, shuffle, "
            "step_in_place, veer_left, veer_right, talk, phone, call, drink, take_picture, lean, sit_on_step, carry, "
            "hold_up, hold_phone, lead, led, push and stick");
}

TEST(RolesByName, OfThingsInHandsAreKnownToo) {
  const Names names{"Idle",         "Phone",     "Call", "Talking_On_Phone", "Drink",
                    "Take_Picture", "Lean_Wall", "Sit",  "Sit_Ground",       "Walk_Carry",
                    "Carry",        "Hold_Up",   "Push", "Push_Up",          "Stick"};
  EXPECT_EQ(clip_for(Role::phone, names), "Phone");
  EXPECT_EQ(clip_for(Role::call, names), "Call");
  EXPECT_EQ(clip_for(Role::call, {"Idle", "Talking_On_Phone"}), "Talking_On_Phone");
  EXPECT_EQ(clip_for(Role::take_picture, names), "Take_Picture");
  EXPECT_EQ(clip_for(Role::sit, names), "Sit");
  EXPECT_EQ(clip_for(Role::sit_on_step, names), "Sit_Ground");
  EXPECT_EQ(clip_for(Role::carry, names), "Carry");
  EXPECT_EQ(clip_for(Role::hold_up, names), "Hold_Up");
  EXPECT_EQ(clip_for(Role::push, {"Idle", "Push_Up"}), "none");
}

TEST(PlayableRole, IsTheNearestThatTheCharacterHasAClipFor) {
  CharacterRoles walker = roles_by_name(Names{"Idle", "Walk", "Run"});
  EXPECT_EQ(walker.playable(Role::walk), std::nullopt) << "a walk that does not get anywhere is none";
  walker.walk_speed = 1.3;
  EXPECT_EQ(walker.playable(Role::run), Role::walk) << "nor is such a run";
  walker.run_speed = 4.0;
  EXPECT_EQ(walker.playable(Role::run), Role::run);
  EXPECT_EQ(walker.playable(Role::jog), Role::walk);
  EXPECT_EQ(walker.playable(Role::sit), Role::stand);
  EXPECT_EQ(walker.playable(Role::look_around), Role::stand);
  EXPECT_EQ(walker.playable(Role::cheer), std::nullopt);
}

TEST(RolesByName, WhatIsNotThereIsNoClip) {
  const Names names{"Walk_Left", "Jump_Idle"};
  EXPECT_EQ(clip_for(Role::stand, names), "none");
  EXPECT_EQ(clip_for(Role::walk, names), "none");
  EXPECT_EQ(clip_for(Role::wave, names), "none");
}

TEST(RolesByName, OthersLeaveOutPosesAndDeaths) {
  EXPECT_THAT(roles_by_name(Names{"T-Pose", "Death_A", "Spin", "Swim"}).others, testing::ElementsAre(2, 3));
}

TEST(RolesByName, ACharacterOfOnePoseStillHasAnOther) {
  EXPECT_THAT(roles_by_name(Names{"T-Pose"}).others, testing::ElementsAre(0));
  EXPECT_THAT(roles_by_name(Names{""}).others, testing::ElementsAre(0));
  EXPECT_TRUE(roles_by_name({}).others.empty());
}

}  // namespace
}  // namespace throng::app::roles_test
