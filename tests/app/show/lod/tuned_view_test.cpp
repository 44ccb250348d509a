#include "app/show/lod/tuned_view.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "app/character/built_in.h"
#include "engine/render/mesh/packed_surface.h"

namespace throng::app::tuned_view_test {
namespace {

float allowed(float error_px, float mesh_error_px) {
  return mesh_rules({.error_px = error_px, .mesh_error_px = mesh_error_px}).tolerance.surface;
}

TEST(TunedMeshes, MayBeOffByTheirOwnLimitAndHalfOfTheLimitOnAllErrors) {
  EXPECT_FLOAT_EQ(allowed(1.0F, 0.25F), 0.25F);
  EXPECT_FLOAT_EQ(allowed(1.0F, 2.0F), 0.5F) << "half of the limit on all errors is the most";
  EXPECT_FLOAT_EQ(allowed(4.0F, 2.0F), 2.0F);
  EXPECT_FLOAT_EQ(allowed(0.0F, 2.0F), 2.0F) << "a budget without a limit";
}

TEST(TunedMeshes, LeaveTheOtherHalfOfTheLimitToPoses) {
  Tuning tuning{.error_px = 1.0F};
  EXPECT_FLOAT_EQ(pose_error_limit(tuning), 0.5F);
  tuning.mesh_lod = 0;
  EXPECT_FLOAT_EQ(pose_error_limit(tuning), 1.0F);
}

// A gap between two meshes draws people who stand just too near for the coarser one with several times the triangles.
TEST(BuiltInMeshes, HaveNoGapBetweenNearAndFarOnes) {
  const auto source = load_built_in(THRONG_SOURCE_DIR);
  ASSERT_TRUE(source);
  const auto surface = render::surface_parts(mesh_data(*source));
  ASSERT_TRUE(surface);
  const std::vector<std::uint32_t>& triangles = surface->pieces[0].triangles_by_level;
  ASSERT_GE(triangles.size(), 2U);
  for (std::size_t lod = 1; lod < triangles.size(); ++lod) {
    EXPECT_GE(triangles[lod] * 3, triangles[lod - 1]) << "mesh " << lod;
  }
  EXPECT_LT(triangles.back(), 100U);
}

}  // namespace
}  // namespace throng::app::tuned_view_test
