#include "engine/anim/asset/reference_pose.h"

#include <cmath>

#include <gtest/gtest.h>

namespace throng::anim::reference_pose_test {
namespace {

Track<glm::vec3> vectors(Interpolation interpolation, std::vector<glm::vec3> values) {
  return {.interpolation = interpolation, .times = {1.0F, 3.0F}, .values = std::move(values)};
}

TEST(ReferenceTrack, HoldsTheNearestKeyOutsideItsKeys) {
  const auto track = vectors(Interpolation::linear, {{1, 0, 0}, {5, 0, 0}});
  EXPECT_EQ(sample_track(track, 0.0).x, 1.0);
  EXPECT_EQ(sample_track(track, 9.0).x, 5.0);
}

TEST(ReferenceTrack, StepKeepsAKeyUntilTheNext) {
  const auto track = vectors(Interpolation::step, {{1, 0, 0}, {5, 0, 0}});
  EXPECT_EQ(sample_track(track, 2.999).x, 1.0);
  EXPECT_EQ(sample_track(track, 3.0).x, 5.0);
}

TEST(ReferenceTrack, CubicTangentsAreScaledByTheSpan) {
  const auto track =
      vectors(Interpolation::cubic_spline, {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {-1, 0, 0}, {5, 0, 0}, {0, 0, 0}});
  // Half way: (1 + 5) / 2 + span * (3 - -1) / 8, by hand from the Hermite basis.
  EXPECT_NEAR(sample_track(track, 2.0).x, 3.0 + 2.0 * (3.0 + 1.0) / 8.0, 1e-12);
}

TEST(ReferenceTrack, RotationsTakeTheShorterArcAndAreUnit) {
  const float half = std::sqrt(0.5F);
  const Track<glm::quat> track{.interpolation = Interpolation::linear,
                               .times = {0.0F, 1.0F},
                               .values = {glm::quat(1, 0, 0, 0), glm::quat(-half, 0, -half, 0)}};
  const glm::dquat middle = sample_track(track, 0.5);
  EXPECT_NEAR(std::abs(middle.w), std::cos(std::acos(-1.0) / 8.0), 1e-7);
  EXPECT_NEAR(glm::length(middle), 1.0, 1e-12);
}

TEST(ReferencePose, PrefixStandsBetweenParentAndBone) {
  Skeleton skeleton;
  skeleton.rigid = false;
  skeleton.bones.resize(2);
  skeleton.bones[0].rest.translation = {1, 0, 0};
  skeleton.bones[1].parent = 0;
  skeleton.bones[1].prefix[3] = glm::dvec4(0, 2, 0, 1);
  skeleton.bones[1].rest.translation = {0, 0, 3};
  skeleton.references.resize(2);
  skeleton.palette = {{.bone = 1}};
  const ReferencePose pose = reference_pose(skeleton, nullptr, 0.0);
  EXPECT_EQ(glm::dvec3(pose.palette[0][3]), glm::dvec3(1, 2, 3));
}

TEST(NearestKeptBone, IsTheBoneItselfOrItsAncestorInTheLevel) {
  Skeleton skeleton;
  skeleton.bones.resize(4);
  skeleton.bones[1].parent = 0;
  skeleton.bones[2].parent = 1;
  skeleton.bones[3].parent = 2;
  EXPECT_EQ(nearest_kept_bone(skeleton, 1, 2), 1);
  EXPECT_EQ(nearest_kept_bone(skeleton, 3, 2), 1);
  EXPECT_EQ(nearest_kept_bone(skeleton, 3, 1), 0);
}

TEST(PaletteCount, IsThatOfTheBonesBelow) {
  Skeleton skeleton;
  skeleton.palette = {{.bone = 0}, {.bone = 1}, {.bone = 1}, {.bone = 3}};
  EXPECT_EQ(palette_count_for_bones(skeleton, 1), 1);
  EXPECT_EQ(palette_count_for_bones(skeleton, 2), 3);
  EXPECT_EQ(palette_count_for_bones(skeleton, 3), 3);
  EXPECT_EQ(palette_count_for_bones(skeleton, 4), 4);
}

}  // namespace
}  // namespace throng::anim::reference_pose_test
