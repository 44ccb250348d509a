#include "app/people/crowd/resting.h"

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "app/people/crowd/crowd.h"
#include "app/people/crowd/plaza_plan.h"
#include "tests/app/people/crowd/crowd_person.h"

namespace throng::app::resting_test {
namespace {

CharacterRoles person_who_rests() {
  CharacterRoles roles = character_with(
      {Role::stand, Role::look_around, Role::walk, Role::sit, Role::lean, Role::sit_on_step, Role::wave});
  roles.bodies = {{.share = 1, .size = 1.0}};
  return roles;
}

std::size_t how_many(const Crowd& crowd, Habit habit) {
  return static_cast<std::size_t>(std::ranges::count(crowd.minds().habits(), habit));
}

TEST(Resting, IsDoneAtTrunksKiosksRimsAndStepsOfAPlaza) {
  const CharacterRoles roles = person_who_rests();
  const Crowd crowd(Scene::plaza, 1000, 1, std::span(&roles, 1), {.bodies = true});
  const Crowd before(Scene::plaza, 1000, 1, roles);
  EXPECT_EQ(crowd.size(), 1000U);
  EXPECT_GT(how_many(crowd, Habit::lean), 8U);
  EXPECT_GT(how_many(crowd, Habit::sit_low), 2U);
  EXPECT_GT(how_many(crowd, Habit::rest), how_many(before, Habit::rest) + 3) << "on the rim of the fountain";
  EXPECT_LT(how_many(crowd, Habit::lean) + how_many(crowd, Habit::sit_low), 100U) << "most people stand";
  for (std::size_t agent = 0; agent < crowd.size(); ++agent) {
    if (crowd.minds().habits()[agent] == Habit::lean) {
      EXPECT_TRUE(crowd.minds().roles()[agent] == Role::lean || crowd.minds().roles()[agent] == Role::look_around);
    }
    if (crowd.minds().habits()[agent] == Habit::sit_low) {
      EXPECT_EQ(crowd.minds().roles()[agent], Role::sit_on_step);
    }
  }
}

TEST(Resting, GoesOnWhereItBegan) {
  const CharacterRoles roles = person_who_rests();
  Crowd crowd(Scene::plaza, 400, 2, std::span(&roles, 1), {.bodies = true});
  const std::vector<glm::vec3> places(crowd.positions().begin(), crowd.positions().end());
  for (int i = 0; i < 600; ++i) crowd.advance(ticks_per_second / 20);
  for (std::size_t agent = crowd.walkers().count(); agent < crowd.size(); ++agent) {
    EXPECT_EQ(crowd.positions()[agent], places[agent]);
    if (crowd.minds().habits()[agent] == Habit::sit_low) {
      EXPECT_EQ(crowd.minds().roles()[agent], Role::sit_on_step);
    }
  }
}

TEST(Resting, HasRoomBesideEverybodyElse) {
  const CharacterRoles roles = person_who_rests();
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    const Crowd crowd(Scene::plaza, 1000, seed, std::span(&roles, 1), {.bodies = true});
    for (std::size_t agent = crowd.walkers().count(); agent < crowd.size(); ++agent) {
      const Habit habit = crowd.minds().habits()[agent];
      if (habit != Habit::lean && habit != Habit::sit_low) continue;
      for (std::size_t other = crowd.walkers().count(); other < crowd.size(); ++other) {
        if (other == agent) continue;
        EXPECT_GT(glm::distance(crowd.positions()[agent], crowd.positions()[other]), 0.45F) << agent << ' ' << other;
      }
    }
  }
}

TEST(Resting, HasTheBackAtATrunkOrAWall) {
  const CharacterRoles roles = person_who_rests();
  const std::vector<Fixture> fixtures = plan_plaza(1000, 1, roles).fixtures;
  for (const RestSpot& place : rest_spots(fixtures, roles.spacing())) {
    const auto behind = std::ranges::min_element(fixtures, {}, [&](const Fixture& fixture) {
      return fixture.kind == FixtureKind::bench || fixture.kind == FixtureKind::lamp
                 ? 1e9
                 : glm::distance(fixture.position, place.position);
    });
    const glm::dvec2 to_it = behind->position - place.position;
    EXPECT_LT(glm::dot(glm::normalize(to_it), forward_of(place.heading)), -0.99);
    EXPECT_LT(glm::length(to_it), radius_of(behind->kind) + 0.3);
  }
}

TEST(Resting, IsOnlyForThoseWhoCan) {
  const CharacterRoles roles = [] {
    CharacterRoles able = person();
    able.bodies = {{.share = 1, .size = 1.0}};
    return able;
  }();
  const Crowd crowd(Scene::plaza, 1000, 1, std::span(&roles, 1), {.bodies = true});
  EXPECT_EQ(how_many(crowd, Habit::lean), 0U);
  EXPECT_EQ(how_many(crowd, Habit::sit_low), 0U);
}

// Seats grow with the distances, so a wide body would sit in the air before them, and a tiny one inside of them.
TEST(Resting, IsOnlyForBodiesOfTheSizeOfTheSeats) {
  CharacterRoles wide = person_who_rests(), tiny = person_who_rests();
  wide.height = 2.4, wide.radius = 1.3;
  tiny.height = 0.5, tiny.radius = 0.1;
  for (const CharacterRoles& roles : {wide, tiny}) {
    const Crowd crowd(Scene::plaza, 300, 1, std::span(&roles, 1), {.bodies = true});
    const std::vector<Obstacle> obstacles = plaza_layout(300, 1, roles).obstacles;
    EXPECT_EQ(how_many(crowd, Habit::rest) + how_many(crowd, Habit::sit_low) + how_many(crowd, Habit::lean), 0U);
    for (const glm::vec3& place : crowd.positions()) {
      EXPECT_EQ(place.y, 0.0F) << "on the plinth of a fountain";
      for (const Obstacle& obstacle : obstacles) {
        EXPECT_GT(glm::distance(obstacle.position, glm::dvec2(place.x, place.z)), obstacle.radius);
      }
    }
  }
}

}  // namespace
}  // namespace throng::app::resting_test
