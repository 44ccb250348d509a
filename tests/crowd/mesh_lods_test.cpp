// The mesh LOD of an agent follows from the error that it shows on screen, and from nothing else.
#include "engine/crowd/mesh_lods.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace throng::mesh_lods_test {
namespace {

class ChosenMeshes : public testing::Test {
 protected:
  ChosenMeshes() { lods_.set(0, {{}, {0.004F, 0.002F}, {0.02F, 0.006F}}, {1000, 500, 100}); }

  MeshLods lods_{2};
  MeshRules rules_;
};

TEST_F(ChosenMeshes, AreTheCoarsestThatAreOffByHalfAPixelAtMost) {
  EXPECT_EQ(lods_.choose(rules_, 0, 1000.0F), 0);
  EXPECT_EQ(lods_.choose(rules_, 0, 126.0F), 0);
  EXPECT_EQ(lods_.choose(rules_, 0, 124.0F), 1);
  EXPECT_EQ(lods_.choose(rules_, 0, 26.0F), 1);
  EXPECT_EQ(lods_.choose(rules_, 0, 24.0F), 2);
  EXPECT_EQ(lods_.choose(rules_, 0, 0.0F), 2);
  EXPECT_FLOAT_EQ(lods_.error_px(0, 1, 124.0F), 0.496F);
}

TEST_F(ChosenMeshes, FollowTheirLimit) {
  rules_.tolerance = mesh_tolerance(0.25F);
  EXPECT_EQ(lods_.choose(rules_, 0, 63.0F), 0);
  EXPECT_EQ(lods_.choose(rules_, 0, 62.0F), 1);
  rules_.tolerance = mesh_tolerance(1.0F);
  EXPECT_EQ(lods_.choose(rules_, 0, 249.0F), 1);
}

TEST_F(ChosenMeshes, AreTheFixedOneWhereTheRulesHaveOne) {
  rules_.lod = 1;
  EXPECT_EQ(lods_.choose(rules_, 0, 1000.0F), 1);
  rules_.lod = 3;
  EXPECT_EQ(lods_.choose(rules_, 0, 1000.0F), 2) << "the coarsest that there is";
}

TEST_F(ChosenMeshes, KnowTheFirstLodThatNoTallAgentShows) {
  lods_.set(1, {{}, {0.001F, 0.001F}, {0.002F, 0.002F}}, {1000, 500, 100});
  EXPECT_EQ(lods_.first_below(rules_, 1, 45.0F, 4), 2U);
  EXPECT_EQ(lods_.first_below(rules_, 1, 130.0F, 4), 1U);
  EXPECT_EQ(lods_.first_below(rules_, 2, 45.0F, 4), 3U) << "the second one is 250 pixels tall with its last";
  rules_.tolerance = mesh_tolerance(3.0F);
  EXPECT_EQ(lods_.first_below(rules_, 1, 45.0F, 4), 3U);
  rules_.triangle_budget = 1000;
  EXPECT_EQ(lods_.first_below(rules_, 1, 200.0F, 4), 4U) << "a budget may show any";
}

TEST_F(ChosenMeshes, KeepTheFaceOfAnAgentAHundredPixelsTallUnderAnyLimit) {
  rules_.tolerance = mesh_tolerance(50.0F);
  EXPECT_EQ(lods_.choose(rules_, 0, 99.0F), 2);
  EXPECT_EQ(lods_.choose(rules_, 0, 100.0F), 1);
}

TEST_F(ChosenMeshes, AreSaidByTheHeightBelowWhichTheyAreFineEnough) {
  for (const float limit : {1.0F, 3.0F, 100.0F}) {
    const MeshTolerance tolerance = rules_.tolerance = mesh_tolerance(limit / 2.0F);
    for (float tall = 2.0F; tall < 2000.0F; tall *= 1.01F) {
      const auto lod = static_cast<std::size_t>(lods_.choose(rules_, 0, tall));
      EXPECT_LE(tall, fine_below(lods_.shares(0)[lod], tolerance) * 1.0001F);
      if (lod == 2) continue;
      EXPECT_GE(tall, fine_below(lods_.shares(0)[lod + 1], tolerance) * 0.9999F);
    }
  }
}

TEST_F(ChosenMeshes, OfACharacterWithoutLodsAreTheFullOne) {
  EXPECT_EQ(lods_.choose(rules_, 1, 1.0F), 0);
  EXPECT_EQ(lods_.error_px(1, 0, 100.0F), 0.0F);
}

}  // namespace
}  // namespace throng::mesh_lods_test
