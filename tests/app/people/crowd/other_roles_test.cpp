// A crowd whose characters get other clips for their roles goes on where it is.

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "app/people/crowd/crowd.h"
#include "tests/app/people/crowd/crowd_person.h"

namespace throng::app::other_roles_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;
constexpr int other_walk = 20;
constexpr Scene scenes[] = {Scene::plaza, Scene::parade, Scene::stadium, Scene::grid};

CharacterRoles with_another_walk(double speed) {
  CharacterRoles roles = person();
  roles.clips[index_of(Role::walk)] = other_walk;
  roles.walk_speed = speed;
  return roles;
}

void pass(Crowd& crowd, int frames) {
  for (int i = 0; i < frames; ++i) crowd.advance(frame);
}

std::vector<glm::vec3> places(const Crowd& crowd) { return {crowd.positions().begin(), crowd.positions().end()}; }

TEST(OtherRoles, AreTakenByThoseWhoPlayThemAndByNobodyElse) {
  for (const Scene scene : scenes) {
    Crowd crowd(scene, 200, 1, person());
    pass(crowd, 200);
    const std::vector<int> before(crowd.minds().clips().begin(), crowd.minds().clips().end());
    const std::vector<glm::vec3> stood = places(crowd);
    const CharacterRoles roles = with_another_walk(1.3);
    const auto requests = crowd.take_roles({&roles, 1});
    const auto walked = std::ranges::count(before, person().clip(Role::walk));
    EXPECT_EQ(std::ssize(requests), walked);
    for (const ClipRequest& request : requests) EXPECT_EQ(request.clip, other_walk);
    for (std::size_t agent = 0; agent < before.size(); ++agent) {
      const bool walks = before[agent] == person().clip(Role::walk);
      EXPECT_EQ(crowd.minds().clips()[agent], walks ? other_walk : before[agent]);
    }
    EXPECT_EQ(places(crowd), stood);
  }
}

TEST(OtherRoles, OfAnotherSpeedMakeNobodyJump) {
  for (const Scene scene : scenes) {
    Crowd crowd(scene, 200, 1, person());
    pass(crowd, 600);
    const CharacterRoles roles = with_another_walk(2.0);
    crowd.take_roles({&roles, 1});
    const std::vector<glm::vec3> before = places(crowd);
    pass(crowd, 1);
    for (std::size_t agent = 0; agent < before.size(); ++agent) {
      EXPECT_LT(glm::distance(crowd.positions()[agent], before[agent]), 0.2F) << agent;
    }
    pass(crowd, 600);
    if (crowd.marchers().count() == 0) continue;
    EXPECT_NEAR(crowd.speeds()[crowd.walkers().count()], 2.0F, 0.3F) << "the ranks march at the new pace";
  }
}

TEST(OtherRoles, LeaveWhoCanNoLongerDoSomethingToStand) {
  Crowd crowd(Scene::grid, 300, 1, person());
  pass(crowd, 300);
  CharacterRoles still = person();
  for (const Role role : {Role::wave, Role::clap, Role::cheer, Role::look_around})
    still.clips[index_of(role)] = no_clip;
  crowd.take_roles({&still, 1});
  for (const int clip : crowd.minds().clips()) EXPECT_EQ(clip, still.clip(Role::stand));
}

TEST(OtherRoles, GiveClipsToThoseWhoHadNone) {
  const CharacterRoles none = character_with({});
  Crowd crowd(Scene::grid, 30, 1, none);
  pass(crowd, 60);
  const CharacterRoles stands = character_with({Role::stand});
  EXPECT_EQ(crowd.take_roles({&stands, 1}).size(), crowd.size());
  pass(crowd, 600);
  for (const int clip : crowd.minds().clips()) EXPECT_EQ(clip, stands.clip(Role::stand));
}

TEST(OtherRoles, AndBackAreTheSameClips) {
  Crowd crowd(Scene::plaza, 200, 1, person());
  pass(crowd, 300);
  const std::vector<int> before(crowd.minds().clips().begin(), crowd.minds().clips().end());
  const CharacterRoles other = with_another_walk(1.0), own = person();
  crowd.take_roles({&other, 1});
  crowd.take_roles({&own, 1});
  EXPECT_TRUE(std::ranges::equal(crowd.minds().clips(), before));
}

}  // namespace
}  // namespace throng::app::other_roles_test
