// Gaits of a character go at the speed and in the direction that is measured on them.

#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "app/character/source.h"
#include "engine/anim/import/import.h"

namespace throng::app::gait_velocity_test {
namespace {

/// The built-in character, as its file has it or with every clip in place.
CharacterSource built_in(bool in_place) {
  auto file = import::import_file(THRONG_SOURCE_DIR "/assets/mannequin.glb");
  EXPECT_TRUE(file) << file.error().message;
  for (anim::Clip& clip : file->models.front().clips) {
    const auto is_root = [&](const anim::BoneTracks& tracks) {
      return file->models.front().skeleton.bones[static_cast<std::size_t>(tracks.bone)].name == "root";
    };
    if (in_place) std::erase_if(clip.tracks, is_root);
  }
  auto source = make_character(*file, 0, {.path = "made.glb", .name = "made"});
  EXPECT_TRUE(source) << source.error().message;
  return std::move(*source);
}

void expect_velocity(const CharacterRoles& roles, Role gait, glm::dvec2 velocity, double within) {
  const glm::dvec2 found = roles.velocity(gait);
  EXPECT_LT(glm::distance(found, velocity), within)
      << role_names.at(index_of(gait)) << " " << found.x << " " << found.y;
  EXPECT_NEAR(roles.ground_speed(gait), glm::length(found), 1e-9) << role_names.at(index_of(gait));
}

void expect_velocities(const CharacterRoles& roles, double within) {
  expect_velocity(roles, Role::walk, {0.0, 1.35}, within);
  expect_velocity(roles, Role::jog, {0.0, 2.4}, 2.0 * within);
  expect_velocity(roles, Role::run, {0.0, 3.6}, 3.0 * within);
  expect_velocity(roles, Role::walk_back, {0.0, -0.8}, within);
  expect_velocity(roles, Role::step_left, {0.45, 0.0}, within);
  expect_velocity(roles, Role::step_right, {-0.45, 0.0}, within);
  expect_velocity(roles, Role::shuffle, {0.0, 0.45}, within);
  expect_velocity(roles, Role::veer_left, {0.4, 1.2}, within);
  expect_velocity(roles, Role::veer_right, {-0.4, 1.2}, within);
  expect_velocity(roles, Role::step_in_place, {0.0, 0.0}, 1e-9);
  expect_velocity(roles, Role::stand, {0.0, 0.0}, 1e-9);
}

TEST(GaitVelocity, IsThatOfTheRootMotion) { expect_velocities(built_in(false).roles, 1e-3); }

TEST(GaitVelocity, IsThatOfTheFootThatStandsWhereAClipIsInPlace) { expect_velocities(built_in(true).roles, 0.05); }

TEST(GaitVelocity, IsNothingWhereAClipGoesAnotherWayThanItsRoleSays) {
  CharacterSource source = built_in(false);
  RoleClips clips = source.roles.clips;
  std::swap(clips[index_of(Role::step_left)], clips[index_of(Role::step_right)]);
  clips[index_of(Role::walk_back)] = clips[index_of(Role::walk)];
  assign_roles(source, clips);
  for (const Role gait : {Role::step_left, Role::step_right, Role::walk_back}) {
    expect_velocity(source.roles, gait, {0.0, 0.0}, 1e-9);
  }
}

TEST(GaitVelocity, IsNothingForAShuffleThatIsAsFastAsTheWalk) {
  CharacterSource source = built_in(false);
  RoleClips clips = source.roles.clips;
  clips[index_of(Role::shuffle)] = clips[index_of(Role::walk)];
  assign_roles(source, clips);
  expect_velocity(source.roles, Role::shuffle, {0.0, 0.0}, 1e-9);
}

}  // namespace
}  // namespace throng::app::gait_velocity_test
