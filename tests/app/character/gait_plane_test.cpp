// The blend space of a character's gaits.

#include "app/character/gait_plane.h"

#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "app/character/built_in.h"

namespace throng::app::gait_plane_test {
namespace {

using Points = std::vector<anim::BlendPoint2d>;

Points points_of(const CharacterRoles& roles, int clip_count) {
  const auto plane = gait_plane(roles, clip_count);
  EXPECT_TRUE(plane) << plane.error().message;
  if (!plane) return {};
  EXPECT_EQ((*plane)->meaning(), PlaneMeaning::velocity);
  return {(*plane)->all().begin(), (*plane)->all().end()};
}

/// Returns the place at which a clip is played alone; of several the first.
glm::vec2 place_of(const Points& points, int clip) {
  for (const anim::BlendPoint2d& point : points) {
    if (point.clip == clip) return point.place;
  }
  ADD_FAILURE() << "no point plays clip " << clip;
  return {};
}

CharacterRoles with_clips(const std::vector<std::string>& names) { return roles_by_name(names); }

TEST(GaitPlane, HasEveryGaitOfTheBuiltInCharacterAtItsVelocity) {
  const auto character = load_built_in(THRONG_SOURCE_DIR);
  ASSERT_TRUE(character) << character.error().message;
  const CharacterRoles& roles = character->roles;
  const Points points = points_of(roles, static_cast<int>(character->clip_names.size()));
  EXPECT_EQ(points.size(), 10U);
  const auto expect_at = [&](Role role, glm::vec2 place) {
    const glm::vec2 found = place_of(points, roles.clip(role));
    EXPECT_LT(glm::distance(found, place), 1e-3F) << role_names.at(index_of(role)) << " " << found.x << " " << found.y;
  };
  expect_at(Role::stand, {0.0F, 0.0F});
  expect_at(Role::shuffle, {0.0F, 0.45F});
  expect_at(Role::walk, {0.0F, 1.35F});
  expect_at(Role::jog, {0.0F, 2.4F});
  expect_at(Role::run, {0.0F, 3.6F});
  expect_at(Role::walk_back, {0.0F, -0.8F});
  expect_at(Role::step_left, {0.45F, 0.0F});
  expect_at(Role::step_right, {-0.45F, 0.0F});
  expect_at(Role::veer_left, {0.4F, 1.2F});
  expect_at(Role::veer_right, {-0.4F, 1.2F});
}

TEST(GaitPlane, StepsInTheMiddleWhereThatIsAskedForAndThereIsAClip) {
  CharacterRoles roles = with_clips({"Idle", "Walk", "March_In_Place"});
  roles.walk_speed = 1.2;
  EXPECT_EQ((*gait_plane(roles, 3))->point(0).clip, 0);
  EXPECT_EQ((*gait_plane(roles, 3, Middle::steps))->point(0).clip, 2);
  EXPECT_EQ((*gait_plane(roles, 3, Middle::steps))->point(0).pace, Pace::gait) << "it keeps step";
  roles.clips[index_of(Role::step_in_place)] = no_clip;
  EXPECT_EQ((*gait_plane(roles, 3, Middle::steps))->point(0).clip, 0);
}

TEST(GaitPlane, HasNoTwoClipsAtOneVelocity) {
  CharacterRoles roles = with_clips({"Idle", "Walk", "Strafe_Left", "Strafe_Right", "Fwd_Left"});
  roles.walk_speed = 1.2;
  roles.velocities[index_of(Role::step_left)] = {0.7, 0.3};
  roles.velocities[index_of(Role::veer_left)] = {0.7, 0.32};
  EXPECT_EQ(points_of(roles, 5).size(), 5U) << "standing, walk, one of the two, and two that stand in";
}

TEST(GaitPlane, LetsAWalkTrampleWhereThereAreNoStepsAsideAndBack) {
  CharacterRoles roles = with_clips({"Idle", "Walk"});
  roles.walk_speed = 1.2;
  const Points points = points_of(roles, 2);
  ASSERT_EQ(points.size(), 5U);
  const auto plane = gait_plane(roles, 2);
  for (const glm::vec2 aside : {glm::vec2(0.5F, 0.0F), glm::vec2(-0.5F, 0.0F), glm::vec2(0.0F, -0.5F)}) {
    const anim::BlendPlane::Shares shares = (*plane)->plane().shares(aside);
    EXPECT_LT(glm::distance(shares.place, aside), 1e-6F) << "inside of the plane";
    float standing = 0.0F;
    for (const auto& share : shares.all()) standing += (*plane)->point(share.point).clip == 0 ? share.weight : 0.0F;
    EXPECT_GT(standing, 0.7F) << "most of it stands";
    EXPECT_LT(standing, 0.9F) << "and some of it steps";
  }
}

TEST(GaitPlane, PrefersTheShuffleToTheWalkForThat) {
  CharacterRoles roles = with_clips({"Idle", "Walk", "Shuffle"});
  roles.walk_speed = 1.2;
  roles.velocities[index_of(Role::shuffle)] = {0.0, 0.4};
  const Points points = points_of(roles, 3);
  ASSERT_EQ(points.size(), 6U);
  EXPECT_EQ(points.back().clip, roles.clip(Role::shuffle));
  EXPECT_EQ(points.back().place, glm::vec2(-0.8F, 0.0F));
}

TEST(GaitPlane, PutsAClipThatGoesNearlyStraightStraightAndAnotherWhereItGoes) {
  CharacterRoles roles = with_clips({"Idle", "Walk", "Strafe_Left", "Strafe_Right"});
  roles.walk_speed = 1.2;
  roles.velocities[index_of(Role::step_left)] = {0.7, 0.05};
  roles.velocities[index_of(Role::step_right)] = {-0.7, 0.4};
  const Points points = points_of(roles, 4);
  EXPECT_EQ(place_of(points, 2).y, 0.0F);
  EXPECT_EQ(place_of(points, 3), glm::vec2(-0.7F, 0.4F));
}

TEST(GaitPlane, OnlyStandsWhereNobodyCanWalk) {
  const Points points = points_of(with_clips({"Pose", "Wobble"}), 2);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points.front().clip, 1) << "the first that may be repeated in place";
  EXPECT_EQ(points_of(with_clips({"Idle", "Walk"}), 2).size(), 1U) << "a walk that gets nowhere is none";
}

TEST(GaitPlane, RefusesAClipThatTheCharacterDoesNotHave) {
  CharacterRoles roles = with_clips({"Idle", "Walk"});
  roles.walk_speed = 1.2;
  EXPECT_FALSE(gait_plane(roles, 1));
}

}  // namespace
}  // namespace throng::app::gait_plane_test
