// The mesh LOD of an agent follows from the error that it shows on screen, and from nothing else.
#include "app/show/lod/mesh_lods.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "app/character/built_in.h"
#include "engine/render/mesh/packed_surface.h"

namespace throng::app::mesh_lods_test {
namespace {

class ChosenMeshes : public testing::Test {
 protected:
  ChosenMeshes() { lods_.set(0, {{}, {0.004F, 0.002F}, {0.02F, 0.006F}}, {1000, 500, 100}); }

  MeshLods lods_{2};
  Tuning tuning_{.error_px = 1.0F};
};

TEST_F(ChosenMeshes, AreTheCoarsestThatAreOffByHalfAPixelAtMost) {
  EXPECT_EQ(lods_.choose(tuning_, 0, 1000.0F), 0);
  EXPECT_EQ(lods_.choose(tuning_, 0, 126.0F), 0);
  EXPECT_EQ(lods_.choose(tuning_, 0, 124.0F), 1);
  EXPECT_EQ(lods_.choose(tuning_, 0, 26.0F), 1);
  EXPECT_EQ(lods_.choose(tuning_, 0, 24.0F), 2);
  EXPECT_EQ(lods_.choose(tuning_, 0, 0.0F), 2);
  EXPECT_FLOAT_EQ(lods_.error_px(0, 1, 124.0F), 0.496F);
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

TEST_F(ChosenMeshes, FollowTheirLimit) {
  tuning_.mesh_error_px = 0.25F;
  EXPECT_EQ(lods_.choose(tuning_, 0, 63.0F), 0);
  EXPECT_EQ(lods_.choose(tuning_, 0, 62.0F), 1);
  tuning_.mesh_error_px = 2.0F;
  EXPECT_EQ(lods_.choose(tuning_, 0, 124.0F), 1) << "half of the limit on all errors is the most";
  tuning_.error_px = 4.0F;
  EXPECT_EQ(lods_.choose(tuning_, 0, 249.0F), 1);
  tuning_.error_px = 0.0F;  // a budget without a limit
  EXPECT_EQ(lods_.choose(tuning_, 0, 249.0F), 1);
}

TEST_F(ChosenMeshes, AreTheFixedOneWhereTheTuningHasOne) {
  tuning_.mesh_lod = 1;
  EXPECT_EQ(lods_.choose(tuning_, 0, 1000.0F), 1);
  tuning_.mesh_lod = 3;
  EXPECT_EQ(lods_.choose(tuning_, 0, 1000.0F), 2) << "the coarsest that there is";
}

TEST_F(ChosenMeshes, SayWithWhichOneNobodyIsTall) {
  lods_.set(1, {{}, {0.001F, 0.001F}, {0.002F, 0.002F}}, {1000, 500, 100});
  EXPECT_EQ(lods_.first_below(tuning_, 1, 45.0F, 4), 2U);
  EXPECT_EQ(lods_.first_below(tuning_, 1, 130.0F, 4), 1U);
  EXPECT_EQ(lods_.first_below(tuning_, 2, 45.0F, 4), 3U) << "the second one is 250 pixels tall with its last";
  tuning_ = {.error_px = 6.0F, .mesh_error_px = 3.0F};
  EXPECT_EQ(lods_.first_below(tuning_, 1, 45.0F, 4), 3U);
  tuning_.triangle_budget = 1000;
  EXPECT_EQ(lods_.first_below(tuning_, 1, 200.0F, 4), 4U) << "a budget may show any";
}

TEST_F(ChosenMeshes, KeepTheFaceOfWhoIsAHundredPixelsTallUnderAnyLimit) {
  tuning_ = {.error_px = 100.0F, .mesh_error_px = 50.0F};
  EXPECT_EQ(lods_.choose(tuning_, 0, 99.0F), 2);
  EXPECT_EQ(lods_.choose(tuning_, 0, 100.0F), 1);
}

TEST_F(ChosenMeshes, AreSaidByTheHeightBelowWhichTheyAreFineEnough) {
  for (const float limit : {1.0F, 3.0F, 100.0F}) {
    tuning_ = {.error_px = limit, .mesh_error_px = limit};
    const MeshTolerance tolerance = mesh_tolerance(tuning_);
    for (float tall = 2.0F; tall < 2000.0F; tall *= 1.01F) {
      const auto lod = static_cast<std::size_t>(lods_.choose(tuning_, 0, tall));
      EXPECT_LE(tall, fine_below(lods_.shares(0)[lod], tolerance) * 1.0001F);
      if (lod == 2) continue;
      EXPECT_GE(tall, fine_below(lods_.shares(0)[lod + 1], tolerance) * 0.9999F);
    }
  }
}

TEST_F(ChosenMeshes, OfACharacterWithoutLodsAreTheFullOne) {
  EXPECT_EQ(lods_.choose(tuning_, 1, 1.0F), 0);
  EXPECT_EQ(lods_.error_px(1, 0, 100.0F), 0.0F);
}

TEST_F(ChosenMeshes, LeaveTheOtherHalfOfTheLimitToPoses) {
  EXPECT_FLOAT_EQ(pose_error_limit(tuning_), 0.5F);
  tuning_.mesh_lod = 0;
  EXPECT_FLOAT_EQ(pose_error_limit(tuning_), 1.0F);
}

}  // namespace
}  // namespace throng::app::mesh_lods_test
