#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "app/people/crowd/company.h"
#include "app/people/crowd/crowd.h"
#include "tests/app/people/crowd/crowd_person.h"

namespace throng::app::gatherings_test {
namespace {

CharacterRoles person_with_camera() {
  CharacterRoles roles = character_with({Role::stand, Role::look_around, Role::walk, Role::wave, Role::cheer,
                                         Role::clap, Role::phone, Role::take_picture});
  roles.bodies = {{.share = 1, .size = 1.0}};
  return roles;
}

class GatheringsOfAPlaza : public testing::Test {
 protected:
  glm::vec2 place_of(std::size_t agent) const { return {crowd_.positions()[agent].x, crowd_.positions()[agent].z}; }
  glm::vec2 way_of(std::size_t agent) const { return {crowd_.headings()[agent].sine, crowd_.headings()[agent].cosine}; }
  bool looks_at(std::size_t agent, std::size_t other) const {
    return glm::dot(glm::normalize(place_of(other) - place_of(agent)), way_of(agent)) > 0.8F;
  }
  std::vector<std::size_t> all_of(Habit habit) const {
    std::vector<std::size_t> all;
    for (std::size_t agent = 0; agent < crowd_.size(); ++agent) {
      if (crowd_.minds().habits()[agent] == habit) all.push_back(agent);
    }
    return all;
  }

  CharacterRoles roles_ = person_with_camera();
  Crowd crowd_{Scene::plaza, 1000, 1, std::span(&roles_, 1), {.bodies = true}};
};

TEST_F(GatheringsOfAPlaza, FaceWhoTakesThePicture) {
  ASSERT_GT(all_of(Habit::pose).size(), 8U);
  for (const std::size_t agent : all_of(Habit::pose)) {
    std::size_t camera = agent;
    while (crowd_.minds().habits()[camera] == Habit::pose) --camera;
    ASSERT_EQ(crowd_.minds().habits()[camera], Habit::photograph);
    EXPECT_TRUE(looks_at(agent, camera));
    EXPECT_TRUE(looks_at(camera, agent));
    const float away = glm::distance(place_of(agent), place_of(camera));
    EXPECT_GT(away, 1.2F);
    EXPECT_LT(away, 3.0F);
  }
}

TEST_F(GatheringsOfAPlaza, BeginWithTheCameraUp) {
  ASSERT_GT(all_of(Habit::photograph).size(), 8U);
  for (const std::size_t agent : all_of(Habit::photograph)) {
    EXPECT_TRUE(crowd_.minds().roles()[agent] == Role::take_picture || crowd_.minds().roles()[agent] == Role::stand ||
                crowd_.minds().roles()[agent] == Role::look_around);
  }
}

TEST_F(GatheringsOfAPlaza, StandFarEnoughFromEachOther) {
  for (std::size_t agent = crowd_.walkers().count(); agent < crowd_.size(); ++agent) {
    const Habit habit = crowd_.minds().habits()[agent];
    if (habit != Habit::pose && habit != Habit::photograph && habit != Habit::wait) continue;
    for (std::size_t other = crowd_.walkers().count(); other < crowd_.size(); ++other) {
      if (other == agent) continue;
      EXPECT_GT(glm::distance(place_of(agent), place_of(other)), 0.4F) << agent << ' ' << other;
    }
  }
}

TEST_F(GatheringsOfAPlaza, LetWhoIsAloneWaitAndNotApplaud) {
  ASSERT_GT(all_of(Habit::wait).size(), 20U);
  for (int i = 0; i < 600; ++i) {
    crowd_.advance(ticks_per_second / 10);
    for (const std::size_t agent : all_of(Habit::wait)) {
      EXPECT_NE(crowd_.minds().roles()[agent], Role::cheer);
      EXPECT_NE(crowd_.minds().roles()[agent], Role::clap);
    }
  }
}

TEST(Gatherings, OfSomebodyWithoutThatClipStand) {
  CharacterRoles roles = person();
  roles.bodies = {{.share = 1, .size = 1.0}};
  const Crowd crowd(Scene::plaza, 1000, 1, std::span(&roles, 1), {.bodies = true});
  EXPECT_EQ(std::ranges::count(crowd.minds().roles(), Role::other), 0);
}

TEST(Gatherings, AreNotOfACrowdWithoutAWardrobe) {
  const Crowd crowd(Scene::plaza, 1000, 1, person_with_camera());
  for (const Habit habit : {Habit::pose, Habit::photograph, Habit::wait, Habit::lean, Habit::sit_low}) {
    EXPECT_EQ(std::ranges::count(crowd.minds().habits(), habit), 0);
  }
}

}  // namespace
}  // namespace throng::app::gatherings_test
