#include "engine/anim/survey/bone_lod.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/survey/bone_importance.h"
#include "engine/anim/survey/lod_survey.h"

namespace throng::anim::bone_lod_test {
namespace {

using testing::ElementsAre;

constexpr float length = 0.5F;

/// Each below the one before.
std::vector<Bone> chain_of(int count) {
  std::vector<Bone> bones(static_cast<std::size_t>(count));
  for (int bone = 0; bone < count; ++bone) {
    bones[static_cast<std::size_t>(bone)].node = bone;
    bones[static_cast<std::size_t>(bone)].parent = bone - 1;
  }
  return bones;
}

/// A post of two bones with a mesh of one vertex each, half a metre above its joint. The upper bone turns up to a
/// quarter turn about x; 2 sin(45 degrees) of its length is how far its vertex goes.
Model nodding_post() {
  Model model;
  Skeleton& skeleton = model.skeleton;
  skeleton.bones = chain_of(2);
  skeleton.bones[1].rest.translation = {0.0F, length, 0.0F};
  skeleton.references.resize(2);
  skeleton.references[1].origin = {0.0, static_cast<double>(length), 0.0};
  skeleton.palette = {{.bone = 0}, {.bone = 1}};
  skeleton.level_bone_counts = {2, 1};
  SkinnedMesh mesh;
  mesh.positions = {{0.0F, length, 0.0F}, {0.0F, 2 * length, 0.0F}};
  mesh.palette_entries = {{0, 0, 0, 0}, {1, 0, 0, 0}};
  mesh.weights = {{1, 0, 0, 0}, {1, 0, 0, 0}};
  model.meshes = {mesh};
  Clip nod;
  nod.duration = 1.0;
  const glm::quat quarter = glm::angleAxis(1.5707964F, glm::vec3(1.0F, 0.0F, 0.0F));
  BoneTracks tracks;
  tracks.bone = 1;
  tracks.rotation = {.times = {0.0F, 0.001F, 1.0F}, .values = {{1, 0, 0, 0}, quarter, quarter}};
  nod.tracks = {tracks};
  model.clips = {nod};
  return model;
}

TEST(BoneErrors, AreHowFarTheSurfaceIsOffWithoutTheBone) {
  const std::vector<double> errors = bone_errors(nodding_post());
  EXPECT_NEAR(errors[1], 2.0 * std::sin(std::numbers::pi / 4.0) * static_cast<double>(length), 1e-6);
  EXPECT_NEAR(errors[0], errors[1], 1e-6) << "without the foot the head stays where it was bound, too";
}

TEST(BoneLod, HasTheErrorOfEveryBoneAndLevelInMetres) {
  const BoneLod lod = measure_bone_lod(nodding_post());
  const float error = std::sqrt(2.0F) * length;
  ASSERT_EQ(lod.rows.size(), 2U);
  EXPECT_EQ(lod.rows[0].level, 1);
  EXPECT_EQ(lod.rows[1].level, 0);
  EXPECT_NEAR(lod.rows[1].error_metres, error, 1e-5F);
  EXPECT_EQ(lod.level_error_metres[0], 0.0F);
  for (std::size_t level = 1; level < max_bone_levels; ++level) {
    EXPECT_NEAR(lod.level_error_metres[level], error, 1e-5F) << "a level that is not there repeats the coarsest";
  }
}

TEST(BoneLod, ComesWithABakedCharacterAndNeverFallsFromLevelToLevel) {
  const Character character = bake_character(synthetic_model(62, 2));
  ASSERT_EQ(character.bone_lod.rows.size(), 62U);
  ASSERT_GT(character.skeleton.level_bone_counts.size(), 1U);
  EXPECT_GT(character.bone_lod.level_error_metres[1], 0.0F);
  EXPECT_TRUE(std::ranges::is_sorted(character.bone_lod.level_error_metres));
}

TEST(Percentile99, LeavesOutTheFarthestOfAHundred) {
  std::vector<float> values(100, 1.0F);
  values[17] = 9.0F;
  EXPECT_EQ(percentile_99(values), 1.0F);
  values[18] = 8.0F;
  EXPECT_EQ(percentile_99(values), 8.0F);
  EXPECT_EQ(percentile_99({}), 0.0F);
}

TEST(KeptEntries, AreThoseOfTheNearestKeptAncestorThatHasAny) {
  Skeleton skeleton;
  skeleton.rigid = false;
  skeleton.bones = chain_of(4);
  skeleton.palette = {{.bone = 0}, {.bone = 2}, {.bone = 3}};
  EXPECT_THAT(kept_entries(skeleton, 4), ElementsAre(0, 1, 2));
  EXPECT_THAT(kept_entries(skeleton, 3), ElementsAre(0, 1, 1));
  EXPECT_THAT(kept_entries(skeleton, 2), ElementsAre(0, 0, 0)) << "no skin uses bone 1";
}

TEST(StillPose, PutsEachBoneOfAScaledSkeletonWhereItWasBound) {
  Skeleton skeleton;
  skeleton.rigid = false;
  skeleton.bones = chain_of(2);
  skeleton.references.resize(2);
  glm::dmat4 bound(1.0);
  bound[3] = {0.0, 2.0, 0.0, 1.0};
  skeleton.palette = {{.bone = 0}, {.bone = 1, .post = glm::inverse(bound)}};
  const std::vector<float> pose = still_pose(skeleton);
  constexpr std::size_t lane = 1, lanes = 16;
  EXPECT_FLOAT_EQ(pose[3 * lanes + lane], 1.0F) << "does not turn";
  EXPECT_FLOAT_EQ(pose[5 * lanes + lane], 2.0F) << "two metres above its parent, though its rest transform says none";
  EXPECT_FLOAT_EQ(pose[7 * lanes + lane], 1.0F);
}

}  // namespace
}  // namespace throng::anim::bone_lod_test
