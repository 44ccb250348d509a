#include "app/people/crowd/habits.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "app/people/crowd/minds.h"
#include "tests/app/people/crowd/crowd_person.h"

namespace throng::app::habits_test {
namespace {

constexpr Habit all_habits[] = {Habit::stroll, Habit::stand_about, Habit::march, Habit::watch,
                                Habit::sit,    Habit::train,       Habit::wait,  Habit::pose};

bool is_listed(Habit habit, Role from, Role to) {
  return std::ranges::any_of(transitions(), [&](const Transition& transition) {
    return transition.habit == habit && transition.from == from && transition.to == to;
  });
}

TEST(Transitions, AreAllThatEverHappens) {
  for (const Habit habit : all_habits) {
    Random whim(1, static_cast<std::uint64_t>(habit));
    Role role = first_role(habit, person(), whim);
    for (int i = 0; i < 1000; ++i) {
      const Role next = next_role(habit, role, person(), whim);
      EXPECT_TRUE(habit == Habit::march ? next == role : is_listed(habit, role, next)) << role_names.at(index_of(role));
      role = next;
    }
  }
}

TEST(Transitions, LeadBackFromEveryRoleThatTheyLeadTo) {
  for (const Transition& transition : transitions()) {
    EXPECT_GT(transition.weight, 0.0F);
    EXPECT_TRUE(std::ranges::any_of(transitions(), [&](const Transition& next) {
      return next.habit == transition.habit && next.from == transition.to;
    })) << role_names.at(index_of(transition.to));
  }
}

TEST(Transitions, OfRolesWithoutAClipAreNotTaken) {
  const CharacterRoles quiet = character_with({Role::stand, Role::clap});
  Random whim(1, 1);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(next_role(Habit::watch, Role::stand, quiet, whim), Role::clap);
  const CharacterRoles lonely = character_with({Role::walk});
  for (int i = 0; i < 100; ++i) EXPECT_EQ(next_role(Habit::sit, Role::sit, lonely, whim), Role::sit);
}

TEST(Transitions, AreChosenByWeight) {
  Random whim(1, 1);
  int walks_on = 0, stops = 0;
  for (int i = 0; i < 3000; ++i) {
    const Role next = next_role(Habit::stroll, Role::walk, person(), whim);
    walks_on += next == Role::walk ? 1 : 0;
    stops += next == Role::stand ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(walks_on) / stops, 3.0, 0.5);
}

TEST(Transitions, ToWhatAThingIsForAreForWhoHoldsIt) {
  const CharacterRoles able = character_with({Role::stand, Role::phone, Role::call, Role::drink, Role::wave});
  Random whim(1, 1);
  std::set<Role> of_nobody, of_phone, of_cup;
  for (int i = 0; i < 300; ++i) {
    of_nobody.insert(next_role(Habit::stand_about, Role::stand, able, whim));
    of_phone.insert(next_role(Habit::stand_about, Role::stand, able, whim, HeldThing::phone));
    of_cup.insert(next_role(Habit::stand_about, Role::stand, able, whim, HeldThing::cup));
  }
  EXPECT_EQ(of_nobody, (std::set{Role::look_around, Role::wave}));
  EXPECT_EQ(of_phone, (std::set{Role::look_around, Role::phone, Role::call}));
  EXPECT_EQ(of_cup, (std::set{Role::look_around, Role::drink}));
}

TEST(CrowdMinds, ShowWhatTheCharacterCanPlayOfWhatTheyHaveInMind) {
  const CharacterRoles seatless = character_with({Role::stand});
  const CrowdCast cast = standing(seatless, 1);
  const CrowdMinds minds(cast, {Habit::sit}, 1);
  EXPECT_EQ(minds.intentions()[0], Role::sit);
  EXPECT_EQ(minds.roles()[0], Role::stand);
}

TEST(CrowdMinds, KeepARoleForItsTime) {
  const CrowdCast cast = standing(person(), 50);
  CrowdMinds minds(cast, std::vector<Habit>(50, Habit::stand_about), 1);
  std::vector<std::uint32_t> everybody(50);
  std::iota(everybody.begin(), everybody.end(), 0U);
  std::vector<Ticks> since(50, Ticks{-1});
  for (Ticks now{}; now < 60 * ticks_per_second; now += ticks_per_second / 60) {
    const std::vector<Role> before(minds.intentions().begin(), minds.intentions().end());
    minds.decide(now, everybody);
    for (const std::uint32_t agent : minds.changed()) {
      const double kept = to_seconds(now - since[agent]);
      const Stay stay = stay_in(before[agent]);
      EXPECT_TRUE(since[agent] < Ticks{} || kept > static_cast<double>(stay.least) - 1e-6);
      EXPECT_LT(kept, static_cast<double>(stay.most) + 0.1);
      since[agent] = now;
    }
  }
}

TEST(CrowdMinds, AreInterruptedAndGoOnFromThere) {
  const CrowdCast cast = standing(person(), 1);
  CrowdMinds minds(cast, {Habit::sit}, 3);
  minds.decide(Ticks{}, std::array{0U});
  minds.interrupt(0, Role::cheer, ticks_per_second);
  ASSERT_EQ(minds.roles()[0], Role::cheer);
  minds.decide(ticks_per_second / 2, std::array{0U});
  EXPECT_EQ(minds.roles()[0], Role::cheer);
  minds.decide(ticks_per_second, std::array{0U});
  EXPECT_EQ(minds.roles()[0], Role::sit);
}

}  // namespace
}  // namespace throng::app::habits_test
