#include "engine/anim/survey/surface_points.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim::surface_points_test {
namespace {

/// A ball of vertices around each joint, each skinned to it alone.
Model with_surface(Model model, int vertices_a_bone) {
  SkinnedMesh mesh;
  for (int bone = 0; bone < model.skeleton.bone_count(); ++bone) {
    const glm::vec3 joint(model.skeleton.references[static_cast<std::size_t>(bone)].origin);
    for (int i = 0; i < vertices_a_bone; ++i) {
      const float angle = static_cast<float>(i) * 2.4F;
      const float radius = 0.01F + 0.001F * static_cast<float>(i);
      mesh.positions.push_back(joint + radius * glm::vec3(std::cos(angle), std::sin(angle), 0.0F));
      mesh.palette_entries.emplace_back(bone, 0, 0, 0);
      mesh.weights.emplace_back(1.0F, 0.0F, 0.0F, 0.0F);
    }
  }
  model.meshes.push_back(mesh);
  return model;
}

std::set<std::uint32_t> entries_of(const SurfacePoints& points) {
  std::set<std::uint32_t> entries;
  for (const PointInfluence& influence : points.influences) entries.insert(influence.entry);
  return entries;
}

TEST(SurfacePoints, RepresentEveryBoneAndFillUpToAHundredAndTwentyEight) {
  const Model model = with_surface(synthetic_model(62, 1), 20);
  const SurfacePoints points = choose_surface_points(model);
  EXPECT_EQ(points.count(), most_surface_points);
  EXPECT_EQ(entries_of(points).size(), 62U);
}

TEST(SurfacePoints, TakeTheVertexOfABoneThatIsFarthestFromItsJoint) {
  constexpr int vertices = 20;
  const Model model = with_surface(synthetic_model(3, 1), vertices);
  const SurfacePoints points = choose_surface_points(model, 3);
  ASSERT_EQ(points.count(), 3U);
  for (std::size_t point = 0; point < 3; ++point) {
    const PointInfluence& influence = points.of(point).front();
    const glm::vec3 joint(model.skeleton.references[influence.entry].origin);
    EXPECT_NEAR(glm::distance(glm::vec3(influence.weighted), joint), 0.01F + 0.001F * (vertices - 1), 1e-5F);
  }
}

TEST(SurfacePoints, AreNoMoreThanAskedForHoweverManyBonesThereAre) {
  const Model model = with_surface(synthetic_model(300, 1), 2);
  EXPECT_EQ(choose_surface_points(model).count(), most_surface_points);
  EXPECT_EQ(choose_surface_points(model, 5).count(), 5U);
}

TEST(SurfacePoints, AreEachVertexOnceWhereThereAreFew) {
  const Model model = with_surface(synthetic_model(2, 1), 3);
  EXPECT_EQ(choose_surface_points(model).count(), 6U);
}

TEST(SurfacePoints, AreTheJointsWhereThereIsNoSurface) {
  EXPECT_EQ(choose_surface_points(synthetic_model(20, 1)).count(), 20U);
}

double largest_displacement(const SurfacePoints& points, const ReferencePose& before, const ReferencePose& after) {
  double largest = 0.0;
  for (std::size_t point = 0; point < points.count(); ++point) {
    glm::dvec4 displacement(0.0);
    for (const PointInfluence& influence : points.of(point)) {
      displacement +=
          (after.palette[influence.entry] - before.palette[influence.entry]) * glm::dvec4(influence.weighted);
    }
    largest = std::max(largest, glm::length(displacement));
  }
  return largest;
}

TEST(SurfacePoints, SeeNearlyAllThatTheWholeSurfaceDoesUnlessTheyAreFew) {
  const Model model = with_surface(synthetic_model(20, 2), 5);
  const SurfacePoints surface = choose_surface_points(model);
  ASSERT_EQ(surface.count(), 100U);
  double least_of_one = 1.0, least_of_many = 1.0;
  for (const Clip& clip : model.clips) {
    for (const double part : {0.125, 0.375, 0.625, 0.875}) {
      const double time = part * clip.duration;
      const ReferencePose before = reference_pose(model.skeleton, &clip, time);
      const ReferencePose after = reference_pose(model.skeleton, &clip, std::min(time + 4.0 / 60.0, clip.duration));
      const auto seen = [&](std::size_t points) {
        return largest_displacement(choose_surface_points(model, points), before, after) /
               largest_displacement(surface, before, after);
      };
      least_of_one = std::min(least_of_one, seen(1));
      least_of_many = std::min(least_of_many, seen(40));
    }
  }
  EXPECT_LT(least_of_one, least_of_many);
  EXPECT_GT(least_of_many, 0.9);
}

}  // namespace
}  // namespace throng::anim::surface_points_test
